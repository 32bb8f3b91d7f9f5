/* tests/fuzz: shapes in one colour: those of whole pixels, clears, points. */
#include "calls.h"

#include "core/draw/shapes_small.h"
#include "core/draw/triangle_small.h"
#include "core/raster/line_small.h"

typedef const struct etch_surface surface;

static void point(struct fuzz_calls *c, fuzz_function *f)
{
    const int16_t x = fuzz_x(c), y = fuzz_y(c);

    ((void (*)(surface *, int16_t, int16_t, uint16_t))f)(&c->s, x, y, fuzz_word(c));
}

static void place_size(struct fuzz_calls *c, fuzz_function *f)
{
    const int16_t x = fuzz_x(c), y = fuzz_y(c), r = fuzz_size(c);

    ((void (*)(surface *, int16_t, int16_t, int16_t, uint16_t))f)(&c->s, x, y, r, fuzz_word(c));
}

static void place_sizes(struct fuzz_calls *c, fuzz_function *f)
{
    const int16_t x = fuzz_x(c), y = fuzz_y(c), w = fuzz_size(c), h = fuzz_size(c);

    ((void (*)(surface *, int16_t, int16_t, int16_t, int16_t, uint16_t))f)(&c->s, x, y, w, h,
                                                                           fuzz_word(c));
}

static void two_places(struct fuzz_calls *c, fuzz_function *f)
{
    const int16_t x0 = fuzz_x(c), y0 = fuzz_y(c), x1 = fuzz_x(c), y1 = fuzz_y(c);

    ((void (*)(surface *, int16_t, int16_t, int16_t, int16_t, uint16_t))f)(&c->s, x0, y0, x1, y1,
                                                                           fuzz_word(c));
}

static void stippled(struct fuzz_calls *c, fuzz_function *f)
{
    const int16_t x0 = fuzz_x(c), y0 = fuzz_y(c), x1 = fuzz_x(c), y1 = fuzz_y(c);
    const uint16_t pattern = fuzz_word(c);

    ((void (*)(surface *, int16_t, int16_t, int16_t, int16_t, uint16_t, uint16_t))f)(
        &c->s, x0, y0, x1, y1, pattern, fuzz_word(c));
}

static void three_places(struct fuzz_calls *c, fuzz_function *f)
{
    const int16_t x0 = fuzz_x(c), y0 = fuzz_y(c), x1 = fuzz_x(c), y1 = fuzz_y(c);
    const int16_t x2 = fuzz_x(c), y2 = fuzz_y(c);

    ((void (*)(surface *, int16_t, int16_t, int16_t, int16_t, int16_t, int16_t, uint16_t))f)(
        &c->s, x0, y0, x1, y1, x2, y2, fuzz_word(c));
}

static void rounded(struct fuzz_calls *c, fuzz_function *f)
{
    const int16_t x = fuzz_x(c), y = fuzz_y(c), w = fuzz_size(c), h = fuzz_size(c);
    const int16_t r = fuzz_size(c);

    ((void (*)(surface *, int16_t, int16_t, int16_t, int16_t, int16_t, uint16_t))f)(
        &c->s, x, y, w, h, r, fuzz_word(c));
}

/* x, y, r, from, sweep */
static void part_of_a_circle(struct fuzz_calls *c, fuzz_function *f)
{
    const int16_t x = fuzz_x(c), y = fuzz_y(c), r = fuzz_size(c);
    const uint16_t from = fuzz_word(c);
    const uint32_t sweep = fuzz_byte(c) == 255 ? fuzz_long(c) : fuzz_word(c) * UINT32_C(2);

    ((void (*)(surface *, int16_t, int16_t, int16_t, uint16_t, uint32_t, uint16_t))f)(
        &c->s, x, y, r, from, sweep, fuzz_word(c));
}

static void part_of_a_ring(struct fuzz_calls *c, fuzz_function *f)
{
    const int16_t x = fuzz_x(c), y = fuzz_y(c), outer = fuzz_size(c), inner = fuzz_size(c);
    const uint16_t from = fuzz_word(c);
    const uint32_t sweep = fuzz_byte(c) == 255 ? fuzz_long(c) : fuzz_word(c) * UINT32_C(2);

    ((void (*)(surface *, int16_t, int16_t, int16_t, int16_t, uint16_t, uint32_t, uint16_t))f)(
        &c->s, x, y, outer, inner, from, sweep, fuzz_word(c));
}

static void points(struct fuzz_calls *c, fuzz_function *f)
{
    const uint16_t n = fuzz_below(c, 12);
    struct etch_point *p = fuzz_memory(n * sizeof *p);

    for (uint16_t i = 0; i < n; i++) {
        p[i] = (struct etch_point){fuzz_x(c), fuzz_y(c)};
    }
    ((void (*)(surface *, const struct etch_point *, size_t, uint16_t))f)(&c->s, p, n,
                                                                          fuzz_word(c));
}

/* Four points: the quadratic takes three of them. */
static void curve(struct fuzz_calls *c, fuzz_function *f)
{
    struct etch_point p[4];

    for (int i = 0; i < 4; i++) {
        p[i] = (struct etch_point){fuzz_x(c), fuzz_y(c)};
    }
    ((void (*)(surface *, const struct etch_point *, uint16_t))f)(&c->s, p, fuzz_word(c));
}

/* Up to three contours of up to six vertices, with room for all edges or too little. */
static void polygon(struct fuzz_calls *c, fuzz_function *f)
{
    struct etch_point v[18];
    uint16_t size[3], total = 0;
    const uint16_t contours = fuzz_below(c, 4);

    for (uint16_t i = 0; i < contours; i++) {
        size[i] = fuzz_below(c, 7);
        total = (uint16_t)(total + size[i]);
    }
    for (uint16_t i = 0; i < total; i++) {
        v[i] = (struct etch_point){fuzz_x(c), fuzz_y(c)};
    }
    const uint16_t room = fuzz_byte(c) < 16 ? fuzz_below(c, 18) : total;
    struct etch_polygon_edge *edge = fuzz_memory(room * sizeof *edge);

    (void)((enum etch_status(*)(surface *, const struct etch_point *, const uint16_t *, uint16_t,
                                uint16_t, struct etch_polygon_edge *, uint16_t))f)(
        &c->s, v, size, contours, fuzz_word(c), edge, room);
}

static void clear(struct fuzz_calls *c, fuzz_function *f)
{
    ((void (*)(surface *, uint16_t))f)(&c->s, fuzz_word(c));
}

static void clear_stencil(struct fuzz_calls *c, fuzz_function *f)
{
    (void)f;
    etch_stencil_clear(&c->s, fuzz_byte(c));
}

/* Row y must be one of the clip. */
static void span(struct fuzz_calls *c, fuzz_function *f)
{
    const struct etch_rect *clip = &c->s.clip;
    const int32_t y = fuzz_y(c), x0 = fuzz_s32(c), x1 = fuzz_s32(c);

    (void)f;
    if (y >= clip->y0 && y < clip->y1) {
        etch_span_fill_small(&c->s, y, x0, x1, fuzz_word(c));
    }
}

static void sized_point(struct fuzz_calls *c, fuzz_function *f)
{
    const int32_t x = fuzz_x_q8(c), y = fuzz_y_q8(c);
    const uint16_t size = fuzz_word(c);
    etch_point_runs *runs = fuzz_byte(c) % 2 == 0 ? etch_point_runs_square : etch_point_runs_round;

    (void)f;
    etch_point_fill(&c->s, x, y, size, fuzz_word(c), runs);
}

static void triangle_q16(struct fuzz_calls *c, fuzz_function *f)
{
    struct etch_point_q16 v[3];

    (void)f;
    for (int i = 0; i < 3; i++) {
        const int32_t x = fuzz_x_q8(c), y = fuzz_y_q8(c);

        v[i].x = fuzz_byte(c) < 8 ? fuzz_s32(c) : x == 8388608 ? INT32_MAX : x * 256;
        v[i].y = fuzz_byte(c) < 8 ? fuzz_s32(c) : y == 8388608 ? INT32_MAX : y * 256;
    }
    etch_triangle_fill_q16(&c->s, v, fuzz_word(c));
}

static void exclusive_or(struct fuzz_calls *c, fuzz_function *f)
{
    struct fuzz_calls again = *c;

    place_sizes(c, f);
    if (fuzz_byte(c) % 2 == 0) {
        place_sizes(&again, f);
    }
}

#define ROW(name, call)                                                                            \
    {                                                                                              \
#name, call, (fuzz_function *)name                                                         \
    }

const struct fuzz_row fuzz_shape_rows[] = {
    ROW(etch_point_draw, point),
    ROW(etch_circle_draw, place_size),
    ROW(etch_circle_draw_small, place_size),
    ROW(etch_circle_fill, place_size),
    ROW(etch_circle_fill_small, place_size),
    ROW(etch_hline_draw, place_size),
    ROW(etch_vline_draw, place_size),
    ROW(etch_rect_fill, place_sizes),
    ROW(etch_rect_fill_small, place_sizes),
    ROW(etch_rect_draw, place_sizes),
    ROW(etch_rect_xor, exclusive_or),
    ROW(etch_ellipse_fill, place_sizes),
    ROW(etch_ellipse_draw, place_sizes),
    ROW(etch_ring_fill, place_sizes),
    ROW(etch_ring_draw, place_sizes),
    ROW(etch_line_draw, two_places),
    ROW(etch_line_draw_small, two_places),
    ROW(etch_line_draw_dda, two_places),
    ROW(etch_line_stipple_draw, stippled),
    ROW(etch_triangle_fill, three_places),
    ROW(etch_triangle_fill_small, three_places),
    ROW(etch_triangle_draw, three_places),
    ROW(etch_triangle_fill_q16, triangle_q16),
    ROW(etch_round_rect_fill, rounded),
    ROW(etch_round_rect_draw, rounded),
    ROW(etch_arc_draw, part_of_a_circle),
    ROW(etch_pie_fill, part_of_a_circle),
    ROW(etch_pie_draw, part_of_a_circle),
    ROW(etch_arc_fill, part_of_a_ring),
    ROW(etch_polyline_draw, points),
    ROW(etch_polygon_draw, points),
    ROW(etch_quadratic_draw, curve),
    ROW(etch_cubic_draw, curve),
    ROW(etch_polygon_fill_evenodd, polygon),
    ROW(etch_polygon_fill_nonzero, polygon),
    ROW(etch_surface_clear, clear),
    ROW(etch_depth_clear, clear),
    ROW(etch_stencil_clear, clear_stencil),
    ROW(etch_span_fill_small, span),
    ROW(etch_point_fill, sized_point),
    {NULL, NULL, NULL},
};
