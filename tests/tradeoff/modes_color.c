/* tradeoff/modes_color.c: colours. See tradeoff.h. */
#include "../../core/draw/dither.h"
#include "../../core/draw/exact.h"
#include "../../core/draw/triangle_small.h"
#include "../../core/fragment/flat.h"
#include "../../core/fragment/gouraud_small.h"
#include "candidates.h"
#include "tradeoff.h"

/* Every triangle by a painter and its kernel. */
#define PAINTS(name, painter, kernel)                                                              \
    void draw_##name(const struct etch_surface *s, const struct tradeoff_scene *scene)             \
    {                                                                                              \
        for (uint16_t i = 0; i < scene->count; i++) {                                              \
            const struct etch_texture_vertex *const w[3] = TRADEOFF_TRIANGLE(scene, i);            \
            const struct etch_vertex *const v[3] = {&w[0]->at, &w[1]->at, &w[2]->at};              \
                                                                                                   \
            painter(s, v, kernel);                                                                 \
        }                                                                                          \
    }

PAINTS(flat, etch_triangle_flat, etch_kernel_flat)
PAINTS(flat_dither, etch_triangle_flat_dither, etch_kernel_gouraud_dither)
PAINTS(precise, etch_triangle_gouraud, etch_kernel_gouraud)
PAINTS(exact, etch_triangle_gouraud_exact, etch_kernel_gouraud_exact)
PAINTS(small, etch_triangle_gouraud_small, etch_kernel_gouraud_small)
PAINTS(dither, etch_triangle_gouraud, etch_kernel_gouraud_dither)
PAINTS(packed, etch_triangle_gouraud, candidate_kernel_packed)
PAINTS(fast, candidate_triangle_fast, etch_kernel_gouraud)
PAINTS(carried, candidate_triangle_carried, NULL)

/* The colours of the vertices, weighted by 16.16 barycentric coordinates. */
static uint16_t mix(void *context, int16_t x, int16_t y, const uint32_t b_q16[3])
{
    const struct etch_vertex *const *v = context;
    const uint32_t r = b_q16[0] * v[0]->r + b_q16[1] * v[1]->r + b_q16[2] * v[2]->r;
    const uint32_t g = b_q16[0] * v[0]->g + b_q16[1] * v[1]->g + b_q16[2] * v[2]->g;
    const uint32_t b = b_q16[0] * v[0]->b + b_q16[1] * v[1]->b + b_q16[2] * v[2]->b;

    (void)x, (void)y;
    /* 8.16 to 5.27: 31 / 255 of it, in 2^-19 */
    return (uint16_t)(((r >> 8) * 31 / 255 + 128) >> 8 << 11 |
                      ((g >> 8) * 63 / 255 + 128) >> 8 << 5 | ((b >> 8) * 31 / 255 + 128) >> 8);
}

void draw_barycentric(const struct etch_surface *s, const struct tradeoff_scene *scene)
{
    for (uint16_t i = 0; i < scene->count; i++) {
        const struct etch_texture_vertex *const w[3] = TRADEOFF_TRIANGLE(scene, i);
        const struct etch_vertex *v[3] = {&w[0]->at, &w[1]->at, &w[2]->at};

        etch_triangle_barycentric(s, v, mix, v);
    }
}
