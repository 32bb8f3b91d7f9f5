/* tradeoff/candidate_packed.c: three channels in one word. See candidates.h. */
#include "../../core/fragment/gouraud.h"
#include "candidates.h"

/* A channel from 5.27 or 6.26 to the top 10 or 12 bits, squeezed by 1/64 round its middle: fields
 * keep 1/4 of a step from their ends, which is what 15 steps rounded to 2^-5 can drift. */
static uint32_t squeezed_wrap(uint32_t v, uint8_t steps_bits)
{
    return v - (v >> 6) + (UINT32_C(1) << (30 - steps_bits));
}

static uint32_t word_wrap(uint32_t r, uint32_t g, uint32_t b)
{
    return (squeezed_wrap(r, 5) >> 22 << 22) + (squeezed_wrap(g, 6) >> 20 << 10) +
           (squeezed_wrap(b, 5) >> 22);
}

/* The step of a field, rounded; squeezed likewise. */
static uint32_t step_wrap(uint32_t d, uint8_t shift)
{
    const int32_t squeezed = (int32_t)d - ((int32_t)d >> 6);

    return (uint32_t)((squeezed + (INT32_C(1) << (shift - 1))) >> shift);
}

void candidate_kernel_packed(const struct etch_surface *surface, int16_t y0,
                             const struct etch_run *runs, uint8_t n, const struct etch_paint *paint)
{
    const struct etch_gouraud_paint *const p = (const struct etch_gouraud_paint *)paint;
    const uint32_t step = etch_wrap_add(
        etch_wrap_add(etch_wrap_mul(step_wrap(p->r.dx, 22), UINT32_C(1) << 22),
                      etch_wrap_mul(step_wrap(p->g.dx, 20), UINT32_C(1) << 10)),
        step_wrap(p->b.dx, 22));

    for (; n != 0; n--, runs++, y0++) {
        uint16_t *pixel = (uint16_t *)(etch_surface_row(surface, surface->pixels, y0) +
                                       (uintptr_t)(uint16_t)runs->x0 * 2);
        int32_t x = runs->x0;

        while (x < runs->x1) {
            const int16_t start = (int16_t)(x & ~15);
            const int32_t stop = start + 16 < runs->x1 ? start + 16 : runs->x1;
            uint32_t w = word_wrap(etch_plane_at(&p->r, start, y0), etch_plane_at(&p->g, start, y0),
                                   etch_plane_at(&p->b, start, y0));

            w = etch_wrap_add(w, etch_wrap_mul(step, (uint32_t)(x - start)));
            for (; x < stop; x++) {
                *pixel++ = (uint16_t)((w >> 16 & 0xF800) | (w >> 11 & 0x7E0) | (w >> 5 & 0x1F));
                w = etch_wrap_add(w, step);
            }
        }
    }
}
