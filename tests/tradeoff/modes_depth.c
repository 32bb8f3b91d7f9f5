/* tradeoff/modes_depth.c: depth. See tradeoff.h. */
#include "../../core/draw/exact.h"
#include "../../core/draw/inverse.h"
#include "../../core/draw/mesh.h"
#include "../../core/draw/ordering.h"
#include "../../core/draw/painter.h"
#include "../../core/fragment/flat.h"
#include "tradeoff.h"

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

PAINTS(depth_precise, etch_triangle_flat_depth, etch_kernel_flat_less)
PAINTS(depth_exact, etch_triangle_flat_depth_exact, etch_kernel_flat_exact_less)
PAINTS(depth_inverse, etch_triangle_flat_inverse, etch_kernel_flat_inverse_less)
PAINTS(buffer, etch_triangle_flat_depth, etch_kernel_flat_less)

static void take_all(struct etch_sink *sink, const struct tradeoff_scene *scene)
{
    for (uint16_t i = 0; i < scene->count; i++) {
        const struct etch_texture_vertex *const w[3] = TRADEOFF_TRIANGLE(scene, i);
        const struct etch_vertex *const v[3] = {&w[0]->at, &w[1]->at, &w[2]->at};

        sink->triangle(sink, v);
    }
}

void draw_ordering(const struct etch_surface *s, const struct tradeoff_scene *scene)
{
    static struct etch_ordered room[1000];
    static uint16_t bucket[256];
    struct etch_ordering order;
    struct etch_raster_sink sink;

    etch_ordering_init(&order, room, 1000, bucket, 256);
    take_all(&order.sink, scene);
    etch_raster_sink_init(&sink, s, etch_triangle_flat, etch_kernel_flat);
    etch_ordering_draw(&order, &sink.sink);
}

void draw_painter(const struct etch_surface *s, const struct tradeoff_scene *scene)
{
    static struct etch_painter_triangle room[8000];
    struct etch_painter painter;
    struct etch_raster_sink sink;

    etch_painter_init(&painter, room, 8000);
    take_all(&painter.sink, scene);
    (void)etch_painter_sort(&painter); /* ENOMEM leaves an order that is wrong in places */
    etch_raster_sink_init(&sink, s, etch_triangle_flat, etch_kernel_flat);
    etch_painter_draw(&painter, &sink.sink);
}
