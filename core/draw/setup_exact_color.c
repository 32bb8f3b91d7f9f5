/* draw/setup_exact_color.c: numerators of a triangle's colours. Called by the exact painters. See
 * setup_exact.h. At a pixel of colour c, N = D (2 full c + 255), so floor(N / (510 D)) is the
 * channel rounded half up; at most 2^48 (126 255 + 255) < 2^63. */
#include "setup_exact.h"

void etch_setup_exact_color(struct etch_gouraud_exact_paint *paint, const struct etch_triangle *t,
                            const struct etch_vertex *const v[3])
{
    uint32_t r[3], g[3], b[3];

    for (uint8_t i = 0; i < 3; i++) {
        r[i] = v[i]->r * UINT32_C(62) + 255;
        g[i] = v[i]->g * UINT32_C(126) + 255;
        b[i] = v[i]->b * UINT32_C(62) + 255;
    }
    paint->depth.area = t->area;
    etch_exact_plane_setup(&paint->r, t, r);
    etch_exact_plane_setup(&paint->g, t, g);
    etch_exact_plane_setup(&paint->b, t, b);
}
