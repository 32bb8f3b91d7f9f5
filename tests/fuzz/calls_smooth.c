/* tests/fuzz: smooth shapes and what paints covers and runs: brushes, gradients, patterns,
 * stipples. */
#include "calls.h"

typedef const struct etch_surface surface;
typedef const struct etch_cover_paint cover_paint;

static int16_t *covers(struct fuzz_calls *c)
{
    const struct etch_rect *clip = &c->s.clip;
    const int32_t width = clip->x1 > clip->x0 ? clip->x1 - clip->x0 : 0;

    return fuzz_memory(((size_t)width + 1) * sizeof(int16_t));
}

static struct etch_point_q8 place(struct fuzz_calls *c)
{
    const int32_t x = fuzz_x_q8(c), y = fuzz_y_q8(c);

    return (struct etch_point_q8){x, y};
}

/* A length up to 2^23, mostly small; below 0 too. */
static int32_t length(struct fuzz_calls *c)
{
    const int32_t v = fuzz_size(c) * INT32_C(256) + fuzz_byte(c);

    return v > 8388608 ? 8388608 : v;
}

/* ---- brushes --------------------------------------------------------------------------------- */

/* What a cover or a run may be painted with. */
static const struct etch_brush *brush(struct fuzz_calls *c)
{
    static uint8_t rows[8] = {0x80, 0x41, 0x22, 0x14, 0x08, 0xFF, 0, 0x55};
    static struct etch_gradient_linear linear;
    static struct etch_gradient_radial radial;
    static struct etch_pattern pattern;
    static struct etch_tile tile;
    static struct etch_ramp ramp;
    const struct etch_stop stops[3] = {
        {fuzz_word(c), 255, 0, 9}, {fuzz_word(c), 0, 255, 0}, {fuzz_word(c), 1, 2, 255}};
    const uint8_t kind = fuzz_byte(c), bits = (uint8_t)(1 + kind / 4 % 8);
    uint16_t *colors = fuzz_memory(sizeof *colors << bits);
    const bool ramped = etch_ramp_init(&ramp, colors, bits, stops, (uint8_t)(1 + kind % 3)) ==
                        ETCH_OK;
    const int16_t x0 = fuzz_x(c), y0 = fuzz_y(c), x1 = fuzz_x(c), y1 = fuzz_y(c);

    if (ramped && kind % 4 == 0 &&
        etch_gradient_linear_init(&linear, &ramp, x0, y0, x1, y1) == ETCH_OK) {
        return &linear.brush;
    }
    if (ramped && kind % 4 == 1 &&
        etch_gradient_radial_init(&radial, &ramp, x0, y0, x1) == ETCH_OK) {
        return &radial.brush;
    }
    if (kind % 4 == 2 && etch_tile_init(&tile, colors, 1, 2, 1, x0, y0) == ETCH_OK) {
        return &tile.brush;
    }
    etch_pattern_init(&pattern, rows, 0x1234, 0xFEDC);
    return &pattern.brush;
}

/* The paint that checks covers, or a brush, half of them through a stipple. */
static cover_paint *paint(struct fuzz_calls *c)
{
    static const uint8_t rows[8] = {0xF0, 0xF0, 0x0F, 0x0F, 0xAA, 0x55, 0xFF, 0};
    static struct etch_cover_brush_paint brushed;
    static struct etch_cover_stipple_paint stippled;
    const uint8_t kind = fuzz_byte(c);

    if (kind < 128) {
        return fuzz_cover_paint(c);
    }
    brushed = (struct etch_cover_brush_paint){
        {kind % 2 == 0 ? etch_cover_brush : etch_cover_brush_swapped}, brush(c), kind};
    stippled = (struct etch_cover_stipple_paint){{etch_cover_stipple}, rows, &brushed.paint};
    return kind < 192 ? &brushed.paint : &stippled.paint;
}

/* Any shape, in runs of brushes and blends. */
static void brushed_runs(struct fuzz_calls *c, fuzz_function *f)
{
    static const uint8_t rows[8] = {0xF0, 0xF0, 0x0F, 0x0F, 0xAA, 0x55, 0xFF, 0};
    static etch_kernel *const kernels[] = {etch_kernel_brush, etch_kernel_brush_blend,
                                           etch_kernel_brush_blend_swapped};
    const uint8_t kind = fuzz_byte(c), opacity = fuzz_byte(c);
    struct etch_flat_blend_paint blend;
    const struct etch_brush_paint brushed = {{kernels[kind % 3]}, brush(c), opacity};
    const struct etch_stipple_paint stippled = {{etch_kernel_stipple}, rows, &brushed.paint};
    const struct etch_paint *with = kind < 128   ? &brushed.paint
                                    : kind < 192 ? &stippled.paint
                                                 : &blend.paint;
    const int16_t x = fuzz_x(c), y = fuzz_y(c), r = fuzz_size(c);

    (void)f;
    etch_flat_blend_init(&blend,
                         kind % 2 == 0 ? etch_kernel_flat_blend : etch_kernel_flat_blend_swapped,
                         fuzz_word(c), opacity);
    if (kind % 4 < 2) {
        etch_ellipse_runs(&c->s, x, y, r, fuzz_size(c), with);
    } else {
        etch_line_stipple_runs(&c->s, x, y, r, fuzz_size(c), fuzz_word(c), with);
    }
}

/* ---- shapes ---------------------------------------------------------------------------------- */

static void disc(struct fuzz_calls *c, fuzz_function *f)
{
    const struct etch_point_q8 at = place(c);
    const int32_t r = length(c);

    (void)f;
    etch_smooth_disc(&c->s, at, r, paint(c), covers(c));
}

/* A circle and its width, a ring and its inner radius. */
static void two_lengths(struct fuzz_calls *c, fuzz_function *f)
{
    const struct etch_point_q8 at = place(c);
    const int32_t r = length(c), other = length(c);

    ((void (*)(surface *, struct etch_point_q8, int32_t, int32_t, cover_paint *, int16_t *))f)(
        &c->s, at, r, other, paint(c), covers(c));
}

static void arc(struct fuzz_calls *c, fuzz_function *f)
{
    const struct etch_point_q8 at = place(c);
    const int32_t outer = length(c), inner = length(c);
    const uint16_t from = fuzz_word(c);
    const uint32_t sweep = fuzz_byte(c) == 255 ? fuzz_long(c) : fuzz_word(c) * UINT32_C(2);

    (void)f;
    etch_smooth_arc(&c->s, at, outer, inner, from, sweep, paint(c), covers(c));
}

static void round_rect(struct fuzz_calls *c, fuzz_function *f)
{
    const struct etch_point_q8 a = place(c), b = place(c);
    const int32_t r = length(c);

    (void)f;
    etch_smooth_round_rect(&c->s, a, b, r, paint(c), covers(c));
}

static void round_frame(struct fuzz_calls *c, fuzz_function *f)
{
    const struct etch_point_q8 a = place(c), b = place(c);
    const int32_t r = length(c), width = length(c);

    (void)f;
    etch_smooth_round_frame(&c->s, a, b, r, width, paint(c), covers(c));
}

/* Places within 2^22. */
static struct etch_point_q8 near_place(struct fuzz_calls *c)
{
    const struct etch_point_q8 p = place(c);

    return (struct etch_point_q8){p.x / 2, p.y / 2};
}

static void line(struct fuzz_calls *c, fuzz_function *f)
{
    const struct etch_point_q8 a = near_place(c), b = near_place(c);
    const int32_t width = 2 + fuzz_word(c) % 32767;

    ((void (*)(surface *, struct etch_point_q8, struct etch_point_q8, int32_t, cover_paint *,
               int16_t *))f)(&c->s, a, b, width, paint(c), covers(c));
}

static void polygon(struct fuzz_calls *c, fuzz_function *f)
{
    const uint16_t n = fuzz_below(c, 9), room = fuzz_byte(c) < 16 ? fuzz_below(c, 9) : n;
    struct etch_smooth_edge *edge = fuzz_memory(room * sizeof *edge);
    struct etch_point_q8 v[8];

    (void)f;
    for (uint16_t i = 0; i < n; i++) {
        v[i] = place(c);
    }
    (void)etch_smooth_polygon(&c->s, v, n, edge, room, paint(c), covers(c));
}

/* Strokes, dashes, arcs and ellipses, as the edges of one shape. */
static void outlines(struct fuzz_calls *c, fuzz_function *f)
{
    static etch_stroke_part *const caps[] = {etch_cap_butt, etch_cap_square, etch_cap_round};
    static etch_stroke_part *const joins[] = {etch_join_miter, etch_join_bevel, etch_join_round};
    const uint8_t kind = fuzz_byte(c);
    const uint16_t room = 600, n = (uint16_t)(2 + kind % 4);
    struct etch_smooth_edge *edge = fuzz_memory(room * sizeof *edge);
    const struct etch_stroke stroke = {fuzz_word(c) % 4096, caps[kind / 4 % 3],
                                       joins[kind / 16 % 3], fuzz_word(c)};
    const int32_t dash[2] = {(1 << 16) + fuzz_word(c) * INT32_C(8), 1 + fuzz_word(c)};
    struct etch_point_q8 v[5];
    struct etch_smooth p;
    const struct etch_outline o = {etch_outline_smooth, &p};
    int16_t *cover = covers(c);

    etch_smooth_init(&p, edge, room);
    etch_smooth_window(&p, &c->s);
    for (uint16_t i = 0; i < n; i++) {
        v[i] = near_place(c);
    }
    switch (kind % 8) {
    case 0: etch_stroke_dashes(&o, v, n, &stroke, dash, 2, fuzz_word(c)); break;
    case 1: etch_outline_ellipse(&o, v[0], length(c), length(c), kind >= 128); break;
    case 2:
        etch_outline_arc(&o, v[0], length(c), length(c), fuzz_word(c), fuzz_word(c) * UINT32_C(2));
        break;
    case 3: etch_outline_round_rect(&o, v[0], v[1], length(c)); break;
    default: etch_stroke_outline(&o, v, n, kind >= 128, &stroke);
    }
    ((void (*)(surface *, struct etch_smooth *, cover_paint *, int16_t *))f)(&c->s, &p, paint(c),
                                                                             cover);
}

#define ROW(name, call)                                                                            \
    {                                                                                              \
#name, call, (fuzz_function *)name                                                         \
    }

const struct fuzz_row fuzz_smooth_rows[] = {
    {"brushes", brushed_runs, NULL},
    {"etch_smooth_disc", disc, NULL},
    ROW(etch_smooth_circle, two_lengths),
    ROW(etch_smooth_ring, two_lengths),
    {"etch_smooth_arc", arc, NULL},
    {"etch_smooth_round_rect", round_rect, NULL},
    {"etch_smooth_round_frame", round_frame, NULL},
    ROW(etch_smooth_line, line),
    ROW(etch_smooth_line_round, line),
    {"etch_smooth_polygon", polygon, NULL},
    ROW(etch_smooth_fill_nonzero, outlines),
    ROW(etch_smooth_fill_evenodd, outlines),
    {NULL, NULL, NULL},
};
