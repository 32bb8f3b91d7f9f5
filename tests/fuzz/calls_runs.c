/* tests/fuzz: shapes handed to a paint, which checks their runs. */
#include "calls.h"

#include "core/raster/triangle_small.h"

typedef const struct etch_surface surface;
typedef const struct etch_paint paint;

static void place_size(struct fuzz_calls *c, fuzz_function *f)
{
    const int16_t x = fuzz_x(c), y = fuzz_y(c), r = fuzz_size(c);

    ((void (*)(surface *, int16_t, int16_t, int16_t, paint *))f)(&c->s, x, y, r, fuzz_paint(c));
}

static void place_sizes(struct fuzz_calls *c, fuzz_function *f)
{
    const int16_t x = fuzz_x(c), y = fuzz_y(c), w = fuzz_size(c), h = fuzz_size(c);

    ((void (*)(surface *, int16_t, int16_t, int16_t, int16_t, paint *))f)(&c->s, x, y, w, h,
                                                                          fuzz_paint(c));
}

static void rounded(struct fuzz_calls *c, fuzz_function *f)
{
    const int16_t x = fuzz_x(c), y = fuzz_y(c), w = fuzz_size(c), h = fuzz_size(c);
    const int16_t r = fuzz_size(c);

    ((void (*)(surface *, int16_t, int16_t, int16_t, int16_t, int16_t, paint *))f)(
        &c->s, x, y, w, h, r, fuzz_paint(c));
}

static uint32_t sweep(struct fuzz_calls *c)
{
    return fuzz_byte(c) == 255 ? fuzz_long(c) : fuzz_word(c) * UINT32_C(2);
}

static void part_of_a_circle(struct fuzz_calls *c, fuzz_function *f)
{
    const int16_t x = fuzz_x(c), y = fuzz_y(c), r = fuzz_size(c);
    const uint16_t from = fuzz_word(c);
    const uint32_t turn = sweep(c);

    ((void (*)(surface *, int16_t, int16_t, int16_t, uint16_t, uint32_t, paint *))f)(
        &c->s, x, y, r, from, turn, fuzz_paint(c));
}

static void part_of_a_ring(struct fuzz_calls *c, fuzz_function *f)
{
    const int16_t x = fuzz_x(c), y = fuzz_y(c), outer = fuzz_size(c), inner = fuzz_size(c);
    const uint16_t from = fuzz_word(c);
    const uint32_t turn = sweep(c);

    ((void (*)(surface *, int16_t, int16_t, int16_t, int16_t, uint16_t, uint32_t, paint *))f)(
        &c->s, x, y, outer, inner, from, turn, fuzz_paint(c));
}

static void line(struct fuzz_calls *c, fuzz_function *f)
{
    const int16_t x0 = fuzz_x(c), y0 = fuzz_y(c), x1 = fuzz_x(c), y1 = fuzz_y(c);

    (void)f;
    etch_line_runs(&c->s, x0, y0, x1, y1, fuzz_paint(c));
}

static void stippled(struct fuzz_calls *c, fuzz_function *f)
{
    const int16_t x0 = fuzz_x(c), y0 = fuzz_y(c), x1 = fuzz_x(c), y1 = fuzz_y(c);
    const uint16_t pattern = fuzz_word(c);

    (void)f;
    etch_line_stipple_runs(&c->s, x0, y0, x1, y1, pattern, fuzz_paint(c));
}

static void rect(struct fuzz_calls *c, fuzz_function *f)
{
    const struct etch_rect r = fuzz_rect(c);

    (void)f;
    etch_rect_runs(&c->s, r, fuzz_paint(c));
}

static void point(struct fuzz_calls *c, fuzz_function *f)
{
    const int32_t x = fuzz_x_q8(c), y = fuzz_y_q8(c);
    const uint16_t size = fuzz_word(c);

    ((etch_point_runs *)f)(&c->s, x, y, size, fuzz_paint(c));
}

static void triangle(struct fuzz_calls *c, fuzz_function *f)
{
    struct etch_point_q8 v[3];
    struct etch_triangle t;

    for (int i = 0; i < 3; i++) {
        v[i] = (struct etch_point_q8){fuzz_x_q8(c), fuzz_y_q8(c)};
    }
    if (f == NULL) {
        etch_triangle_runs_small(&c->s, v, fuzz_paint(c));
    } else if (etch_triangle_setup(&t, v)) {
        ((void (*)(surface *, const struct etch_triangle *, paint *))f)(&c->s, &t, fuzz_paint(c));
    }
}

/* ---- polygons -------------------------------------------------------------------------------- */

static void polygon(struct fuzz_calls *c, fuzz_function *f)
{
    struct etch_polygon p;
    const uint16_t room = fuzz_byte(c) < 16 ? fuzz_below(c, 9) : 72;
    struct etch_polygon_edge *edge = fuzz_memory(room * sizeof *edge);
    struct etch_point_q8 v[6];

    etch_polygon_init(&p, edge, room);
    while (c->at < c->end) {
        const uint8_t what = fuzz_byte(c);
        const uint16_t n = what % 7;

        for (uint16_t i = 0; i < n; i++) {
            v[i] = (struct etch_point_q8){fuzz_x_q8(c), fuzz_y_q8(c)};
        }
        if (what >= 192 && n >= 4) {
            (void)etch_polygon_add_quadratic(&p, v, fuzz_s32(c));
            (void)etch_polygon_add_cubic(&p, v, 1 << fuzz_byte(c) % 24);
            (void)etch_polygon_add_edge(&p, v[3], v[0]);
        } else {
            (void)etch_polygon_add(&p, v, n);
        }
    }
    ((void (*)(surface *, struct etch_polygon *, paint *))f)(&c->s, &p, fuzz_paint(c));
}

static void edge_flags(struct fuzz_calls *c, fuzz_function *f)
{
    struct etch_edge_flags flags;
    const struct etch_rect box = etch_rect_intersect(c->s.window, fuzz_rect(c));
    struct etch_point_q8 v[6];
    const size_t room = etch_rect_is_empty(box)
                            ? 0
                            : ETCH_EDGE_FLAGS_BYTES(box.x1 - box.x0, box.y1 - box.y0);
    uint8_t *bits = fuzz_memory(room);

    (void)f;
    if (etch_edge_flags_init(&flags, box, bits, room) != ETCH_OK) {
        return;
    }
    while (c->at < c->end) {
        const uint16_t n = fuzz_below(c, 7);

        for (uint16_t i = 0; i < n; i++) {
            v[i] = (struct etch_point_q8){fuzz_x_q8(c), fuzz_y_q8(c)};
        }
        etch_edge_flags_add(&flags, v, n);
    }
    etch_edge_flags_runs(&c->s, &flags, fuzz_paint(c));
}

/* ---- shapes given by functions --------------------------------------------------------------- */

static int64_t held(int64_t v, int64_t most)
{
    return v < -most ? -most : v > most ? most : v;
}

static void quadric(struct fuzz_calls *c, fuzz_function *f)
{
    const int64_t up = INT64_C(1) << fuzz_byte(c) % 31;
    const struct etch_quadric q = {
        (int32_t)held(fuzz_s32(c), 1 << 30),      (int32_t)held(fuzz_s32(c), 1 << 30),
        (int32_t)held(fuzz_s32(c), 1 << 30),      held(fuzz_s32(c) * up, INT64_C(1) << 44),
        held(fuzz_s32(c) * up, INT64_C(1) << 44), held(fuzz_s32(c) * up, INT64_C(1) << 61)};

    (void)f;
    if (etch_quadric_check(&q) != ETCH_OK) {
        fuzz_fail("a quadric in range is refused");
    }
    etch_quadric_runs(&c->s, &q, fuzz_paint(c));
}

/* A square standing on a corner: changes by at most 1 a pixel. */
struct diamond {
    struct etch_implicit shape;
    int32_t x, y, r;
};

static int32_t diamond_value(const struct etch_implicit *shape, int16_t x, int16_t y)
{
    const struct diamond *d = (const struct diamond *)(const void *)shape;
    const int32_t dx = x > d->x ? x - d->x : d->x - x, dy = y > d->y ? y - d->y : d->y - y;

    return dx + dy - d->r;
}

static void implicit(struct fuzz_calls *c, fuzz_function *f)
{
    const struct diamond d = {{diamond_value, etch_implicit_side_slope, 1, fuzz_rect(c)},
                              fuzz_x(c),
                              fuzz_y(c),
                              fuzz_size(c)};

    (void)f;
    etch_implicit_runs(&c->s, &d.shape, fuzz_paint(c));
}

#define ROW(name, call)                                                                            \
    {                                                                                              \
#name, call, (fuzz_function *)name                                                         \
    }

const struct fuzz_row fuzz_run_rows[] = {
    ROW(etch_circle_runs, place_size),
    ROW(etch_ellipse_runs, place_sizes),
    ROW(etch_ellipse_outline_runs, place_sizes),
    ROW(etch_ring_runs, place_sizes),
    ROW(etch_ring_outline_runs, place_sizes),
    ROW(etch_round_rect_runs, rounded),
    ROW(etch_round_rect_outline_runs, rounded),
    ROW(etch_arc_line_runs, part_of_a_circle),
    ROW(etch_arc_runs, part_of_a_ring),
    ROW(etch_arc_outline_runs, part_of_a_ring),
    ROW(etch_line_runs, line),
    ROW(etch_line_stipple_runs, stippled),
    ROW(etch_rect_runs, rect),
    ROW(etch_point_runs_square, point),
    ROW(etch_point_runs_round, point),
    ROW(etch_triangle_runs, triangle),
    ROW(etch_triangle_runs_halfspace, triangle),
    {"etch_triangle_runs_small", triangle, NULL},
    ROW(etch_polygon_runs_evenodd, polygon),
    ROW(etch_polygon_runs_nonzero, polygon),
    ROW(etch_edge_flags_runs, edge_flags),
    ROW(etch_quadric_runs, quadric),
    ROW(etch_implicit_runs, implicit),
    {NULL, NULL, NULL},
};
