/* tradeoff/modes_frame.c: edges: none, smooth, and samples; and whole-pixel vertices. See
 * tradeoff.h. Clears of samples and resolves are part of what a mode costs. */
#include "../../core/draw/shapes.h"
#include "../../core/draw/triangle.h"
#include "../../core/fragment/cover.h"
#include "../../core/fragment/flat.h"
#include "../../core/frame/multisample.h"
#include "../../core/frame/shared.h"
#include "../../core/frame/supersample.h"
#include "../../core/raster/smooth.h"
#include "../../core/base/rgb565.h"
#include "tradeoff.h"

static uint16_t samples[16 * TRADEOFF_W * TRADEOFF_H]; /* as many as the largest mode has */

void draw_edges_plain(const struct etch_surface *s, const struct tradeoff_scene *scene)
{
    for (uint16_t i = 0; i < scene->count; i++) {
        const struct etch_texture_vertex *const w[3] = TRADEOFF_TRIANGLE(scene, i);
        const struct etch_vertex *const v[3] = {&w[0]->at, &w[1]->at, &w[2]->at};

        etch_triangle_flat(s, v, etch_kernel_flat);
    }
}

void draw_edges_smooth(const struct etch_surface *s, const struct tradeoff_scene *scene)
{
    int16_t cover[TRADEOFF_W + 1];

    for (uint16_t i = 0; i < scene->count; i++) {
        const struct etch_texture_vertex *const v = &scene->v[3 * i];
        const struct etch_point_q8 p[3] = {{v[0].at.x_q8, v[0].at.y_q8},
                                           {v[1].at.x_q8, v[1].at.y_q8},
                                           {v[2].at.x_q8, v[2].at.y_q8}};
        const struct etch_cover_flat_paint paint = {
            {etch_cover_flat}, etch_rgb565(v->at.r, v->at.g, v->at.b), 255};
        struct etch_smooth_edge edge[3];
        struct etch_smooth shape;

        etch_smooth_init(&shape, edge, 3);
        (void)etch_smooth_add(&shape, p, 3);
        etch_smooth_fill_nonzero(s, &shape, &paint.paint, cover);
    }
}

void draw_multisample(const struct etch_surface *s, const struct tradeoff_scene *scene)
{
    struct etch_multisample m;

    (void)etch_multisample_init(&m, samples, NULL, s->window);
    for (uint8_t i = 0; i < ETCH_SAMPLES; i++)
        etch_surface_clear(&m.sample[i], 0);
    for (uint16_t i = 0; i < scene->count; i++) {
        const struct etch_texture_vertex *const w[3] = TRADEOFF_TRIANGLE(scene, i);
        const struct etch_vertex *const v[3] = {&w[0]->at, &w[1]->at, &w[2]->at};

        etch_multisample_flat(&m, v);
    }
    etch_multisample_resolve(&m, s);
}

void draw_shared(const struct etch_surface *s, const struct tradeoff_scene *scene)
{
    struct etch_shared_samples m;

    (void)etch_shared_init(&m, samples, NULL, s->window);
    for (uint8_t i = 0; i < ETCH_SHARED_SAMPLES; i++)
        etch_surface_clear(&m.sample[i], 0);
    for (uint16_t i = 0; i < scene->count; i++) {
        const struct etch_texture_vertex *const w[3] = TRADEOFF_TRIANGLE(scene, i);
        const struct etch_vertex *const v[3] = {&w[0]->at, &w[1]->at, &w[2]->at};

        etch_shared_flat(&m, v);
    }
    etch_shared_resolve(&m, s);
}

static void draw_large(const struct etch_surface *large, const struct tradeoff_scene *scene, int n)
{
    etch_surface_clear(large, 0);
    for (uint16_t i = 0; i < scene->count; i++) {
        struct etch_vertex moved[3];
        const struct etch_vertex *const v[3] = {&moved[0], &moved[1], &moved[2]};

        for (int k = 0; k < 3; k++) {
            moved[k] = scene->v[3 * i + k].at;
            moved[k].x_q8 *= n;
            moved[k].y_q8 *= n;
        }
        etch_triangle_flat(large, v, etch_kernel_flat);
    }
}

#define SUPERSAMPLES(n)                                                                            \
    void draw_supersample_##n(const struct etch_surface *s, const struct tradeoff_scene *scene)    \
    {                                                                                              \
        struct etch_surface large;                                                                 \
                                                                                                   \
        (void)etch_surface_init(&large, samples, etch_supersample_window(s->window, n),            \
                                (n)*TRADEOFF_W);                                                   \
        draw_large(&large, scene, n);                                                              \
        etch_supersample_resolve_##n(&large, s);                                                   \
    }

SUPERSAMPLES(2)
SUPERSAMPLES(3)
SUPERSAMPLES(4)

/* ---- vertices ----------------------------------------------------------------------------------
 */

void draw_subpixel(const struct etch_surface *s, const struct tradeoff_scene *scene)
{
    draw_edges_plain(s, scene);
}

void draw_whole_pixel(const struct etch_surface *s, const struct tradeoff_scene *scene)
{
    for (uint16_t i = 0; i < scene->count; i++) {
        const struct etch_texture_vertex *const v = &scene->v[3 * i];

        etch_triangle_fill(s, (int16_t)(v[0].at.x_q8 >> 8), (int16_t)(v[0].at.y_q8 >> 8),
                           (int16_t)(v[1].at.x_q8 >> 8), (int16_t)(v[1].at.y_q8 >> 8),
                           (int16_t)(v[2].at.x_q8 >> 8), (int16_t)(v[2].at.y_q8 >> 8),
                           etch_rgb565(v->at.r, v->at.g, v->at.b));
    }
}
