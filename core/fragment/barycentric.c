/* fragment/barycentric.c: a user's function per pixel. Called through a paint that
 * draw/triangle_barycentric.c makes. See barycentric.h. */
#include "barycentric.h"

/* 1.31 to 16.16, rounded, held inside 0 .. limit: a weight that drifted across an end of its
 * range by less than a unit comes back to the end. Below 0 it has wrapped to above 1.5. */
static uint32_t weight_q16(uint32_t b_q31, uint32_t limit)
{
    const uint32_t b = b_q31 > UINT32_C(0xC0000000) ? 0 : (b_q31 + 0x4000) >> 15;

    return b < limit ? b : limit;
}

void etch_kernel_barycentric(const struct etch_surface *surface, int16_t y0,
                             const struct etch_run *runs, uint8_t n, const struct etch_paint *paint)
{
    const struct etch_barycentric_paint *p = (const struct etch_barycentric_paint *)paint;

    for (uint8_t i = 0; i < n; i++) {
        const int16_t y = (int16_t)(y0 + i);
        uint16_t *row = surface->pixels + etch_surface_index(surface, runs[i].x0, y);

        for (int16_t x = runs[i].x0; x < runs[i].x1; x++) {
            uint32_t b_q16[3];
            const uint32_t b0 = weight_q16(etch_plane_at(&p->b[0], x, y), ETCH_Q16_ONE);
            const uint32_t b1 = weight_q16(etch_plane_at(&p->b[1], x, y), ETCH_Q16_ONE - b0);

            b_q16[p->order[0]] = b0;
            b_q16[p->order[1]] = b1;
            b_q16[p->order[2]] = ETCH_Q16_ONE - b0 - b1;
            *row++ = p->color(p->context, x, y, b_q16);
        }
    }
}
