/* tests/unit: clipped triangles counted on a canvas, shared by the suites of clipping. */
#ifndef TESTS_UNIT_CLIP_COUNT_H
#define TESTS_UNIT_CLIP_COUNT_H

#include "core/raster/triangle.h"
#include "core/vertex/assembly.h"
#include "tests/harness/canvas.h"

static inline void note_triangle(const struct etch_clip_vertex v[3])
{
    int i;

    for (i = 0; i < 3; i++) {
        test_note("x", v[i].x);
        test_note("y", v[i].y);
        test_note("z", v[i].z);
        test_note("w", v[i].w);
    }
}

/* Adds 1 to every pixel of a triangle. */
struct counting {
    struct etch_sink sink;
    const struct etch_surface *surface;
    struct test_run_log log;
};

static inline void count(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    struct counting *c = (struct counting *)(void *)sink;
    const struct etch_point_q8 p[3] = {
        {v[0]->x_q8, v[0]->y_q8}, {v[1]->x_q8, v[1]->y_q8}, {v[2]->x_q8, v[2]->y_q8}};
    struct test_run_paint paint = test_run_paint(&c->log, 1);
    struct etch_triangle t;

    paint.count = true;
    if (etch_triangle_setup(&t, p))
        etch_triangle_runs(c->surface, &t, &paint.paint);
}

typedef void assemble(const struct etch_assembly *assembly, const struct etch_clip_vertex v[3]);

static inline void draw(struct test_canvas *canvas, const struct etch_viewport *viewport,
                        const struct etch_clip_vertex v[3], assemble *take)
{
    struct counting counting = {.sink = {count, NULL, NULL}, .surface = &canvas->surface};
    struct etch_assembly assembly = {.viewport = *viewport, .cull = ETCH_CULL_NONE};

    assembly.sink = &counting.sink;
    take(&assembly, v);
}

static inline int32_t times(const struct test_canvas *c, int32_t x, int32_t y)
{
    return test_canvas_at(c, x, y) - TEST_BACKGROUND;
}

#endif
