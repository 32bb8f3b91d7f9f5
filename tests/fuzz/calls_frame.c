/* tests/fuzz: whole surfaces: accumulated, filtered, exchanged, moved, resolved from samples. */
#include "calls.h"

typedef const struct etch_surface surface;

/* Another surface of a window near the first's, with memory of its own. */
static struct etch_surface another(struct fuzz_calls *c)
{
    const struct etch_rect *w = &c->s.window;
    const int16_t x = (int16_t)(w->x0 < 5 ? fuzz_below(c, 9) : w->x0 - 4 + fuzz_below(c, 4));
    const int16_t y = (int16_t)(w->y0 < 5 ? fuzz_below(c, 9) : w->y0 - 4 + fuzz_below(c, 4));
    const int16_t width = (int16_t)(1 + fuzz_below(c, 36)),
                  height = (int16_t)(1 + fuzz_below(c, 28));
    struct etch_rect window = {x, y, (int16_t)(x + width), (int16_t)(y + height)};
    const uint16_t stride = (uint16_t)(width + fuzz_below(c, 3));
    struct etch_surface s;

    if (etch_surface_init(&s, fuzz_memory((size_t)stride * (size_t)height * 2), window, stride) !=
        ETCH_OK) {
        fuzz_fail("another surface is refused");
    }
    if (fuzz_byte(c) >= 128) {
        etch_surface_clip(&s, fuzz_rect(c));
    }
    return s;
}

static void copy(struct fuzz_calls *c, fuzz_function *f)
{
    const struct etch_surface from = another(c);

    ((void (*)(surface *, surface *))f)(&c->s, fuzz_byte(c) < 8 ? &c->s : &from);
}

static void copy_rect(struct fuzz_calls *c, fuzz_function *f)
{
    const struct etch_surface from = another(c);
    const int16_t x = fuzz_x(c), y = fuzz_y(c);
    const struct etch_rect area = fuzz_rect(c);

    (void)f;
    etch_surface_copy_rect(&c->s, x, y, fuzz_byte(c) < 128 ? &c->s : &from, area);
}

static void scroll(struct fuzz_calls *c, fuzz_function *f)
{
    const struct etch_rect area = fuzz_rect(c);
    const int16_t dx = fuzz_size(c), dy = fuzz_size(c);

    (void)f;
    etch_surface_scroll(&c->s, area, dx, dy, fuzz_word(c));
}

/* ---- sums ------------------------------------------------------------------------------------ */

static struct etch_accumulation sums(struct fuzz_calls *c)
{
    const struct etch_surface like = another(c);
    const size_t height = (size_t)(like.window.y1 - like.window.y0);
    struct etch_accumulation a;

    if (etch_accumulation_init(&a, fuzz_memory((size_t)like.stride * height * 6), like.window,
                               like.stride) != ETCH_OK) {
        fuzz_fail("a plane of sums is refused");
    }
    return a;
}

static void accumulate(struct fuzz_calls *c, fuzz_function *f)
{
    const struct etch_accumulation a = sums(c);

    ((void (*)(const struct etch_accumulation *, surface *, uint16_t))f)(&a, &c->s, fuzz_word(c));
    if (fuzz_byte(c) < 128) {
        etch_accumulation_return(&a, &c->s, fuzz_word(c));
    }
}

static void multiply(struct fuzz_calls *c, fuzz_function *f)
{
    const struct etch_accumulation a = sums(c);
    const struct etch_rect area = fuzz_rect(c);
    const uint16_t up = fuzz_word(c), down = fuzz_word(c);

    (void)f;
    etch_accumulation_multiply(&a, area, up, down);
}

/* ---- passes over neighbours ------------------------------------------------------------------ */

/* The surface as a strip of a frame that is a little larger; `source` is drawn on before the pass.
 * */
static bool begin(struct fuzz_calls *c, struct etch_carry *carry, struct etch_surface *source,
                  uint8_t rows, uint8_t columns)
{
    const struct etch_rect *w = &c->s.window;
    const int16_t more = (int16_t)fuzz_below(c, 6);
    const struct etch_rect frame = {(int16_t)(w->x0 < more ? 0 : w->x0 - more),
                                    (int16_t)(w->y0 < more ? 0 : w->y0 - more),
                                    (int16_t)(w->x1 > 32767 - more ? 32767 : w->x1 + more),
                                    (int16_t)(w->y1 > 32767 - more ? 32767 : w->y1 + more)};
    const size_t width = (size_t)(frame.x1 - frame.x0), height = (size_t)(w->y1 - w->y0);

    *source = c->s;
    source->depth = NULL, source->stencil = NULL;
    source->pixels = fuzz_memory(width * (height + 2U * rows) * 2);
    if (etch_carry_init(carry, fuzz_memory(2U * rows * width * 2), frame, rows, columns) !=
        ETCH_OK) {
        fuzz_fail("a carry is refused");
    }
    if (etch_carry_begin(carry, &c->s, source)) {
        etch_surface_clear(source, fuzz_word(c));
        etch_line_draw(source, fuzz_x(c), fuzz_y(c), fuzz_x(c), fuzz_y(c), fuzz_word(c));
        etch_circle_fill(source, fuzz_x(c), fuzz_y(c), fuzz_size(c), fuzz_word(c));
    }
    return true;
}

static void filter(struct fuzz_calls *c, fuzz_function *f)
{
    struct etch_carry carry;
    struct etch_surface source;

    (void)begin(c, &carry, &source, 1, 1);
    ((void (*)(struct etch_carry *, surface *, surface *))f)(&carry, &source, &c->s);
}

static void filter_weights(struct fuzz_calls *c, fuzz_function *f)
{
    struct etch_filter_weights weights;
    struct etch_carry carry;
    struct etch_surface source;

    for (int i = 0; i < 9; i++) {
        weights.weight[i] = (int8_t)(fuzz_byte(c) - 128);
    }
    weights.divisor = fuzz_byte(c);
    weights.bias = (int16_t)(fuzz_below(c, 511) - 255);
    (void)begin(c, &carry, &source, 1, 1);
    ((void (*)(struct etch_carry *, surface *, surface *, const struct etch_filter_weights *))f)(
        &carry, &source, &c->s, &weights);
}

static void smooth(struct fuzz_calls *c, fuzz_function *f)
{
    struct etch_carry carry;
    struct etch_surface source;

    (void)begin(c, &carry, &source, (uint8_t)(2 + fuzz_byte(c) % 3), ETCH_SMOOTH_COLUMNS);
    ((void (*)(struct etch_carry *, surface *, surface *))f)(&carry, &source, &c->s);
}

/* ---- samples --------------------------------------------------------------------------------- */

static void supersample(struct fuzz_calls *c, fuzz_function *f, uint8_t n)
{
    struct etch_rect w = {0, 0, (int16_t)(1 + fuzz_below(c, 20)), (int16_t)(1 + fuzz_below(c, 20))};
    const uint16_t width = (uint16_t)(w.x1 * n), height = (uint16_t)(w.y1 * n);
    struct etch_surface large;

    w = etch_supersample_window(w, n);
    if (etch_surface_init(&large, fuzz_memory((size_t)width * height * 2), w, width) != ETCH_OK) {
        fuzz_fail("a large surface is refused");
    }
    etch_circle_fill(&large, fuzz_x(c), fuzz_y(c), fuzz_size(c), fuzz_word(c));
    ((void (*)(surface *, surface *))f)(&large, &c->s);
}

static void supersample_2(struct fuzz_calls *c, fuzz_function *f)
{
    supersample(c, f, 2);
}

static void supersample_3(struct fuzz_calls *c, fuzz_function *f)
{
    supersample(c, f, 3);
}

static void supersample_4(struct fuzz_calls *c, fuzz_function *f)
{
    supersample(c, f, 4);
}

static void multisample(struct fuzz_calls *c, fuzz_function *f)
{
    const struct etch_rect *w = &c->s.window;
    const size_t n = (size_t)(w->x1 - w->x0) * (size_t)(w->y1 - w->y0) * ETCH_SAMPLES;
    struct etch_multisample m;

    if (etch_multisample_init(&m, fuzz_memory(n * 2), fuzz_memory(n * 2), *w) != ETCH_OK) {
        fuzz_fail("samples are refused");
    }
    if (fuzz_byte(c) < 64) {
        etch_multisample_clip(&m, fuzz_rect(c));
    }
    const struct etch_vertex v[3] = {fuzz_vertex(c), fuzz_vertex(c), fuzz_vertex(c)};
    const struct etch_vertex *const p[3] = {&v[0], &v[1], &v[2]};

    ((etch_multisample_painter *)f)(&m, p);
    (fuzz_byte(c) % 2 == 0 ? etch_multisample_resolve : etch_multisample_resolve_swapped)(&m,
                                                                                          &c->s);
}

static void shared(struct fuzz_calls *c, fuzz_function *f)
{
    const struct etch_rect *w = &c->s.window;
    const size_t n = (size_t)(w->x1 - w->x0 + 1) * (size_t)(w->y1 - w->y0) * ETCH_SHARED_SAMPLES;
    struct etch_shared_samples m;

    if (etch_shared_init(&m, fuzz_memory(n * 2), fuzz_memory(n * 2), *w) != ETCH_OK) {
        if (w->x1 < 32767) {
            fuzz_fail("shared samples are refused");
        }
        return;
    }
    if (fuzz_byte(c) < 64) {
        etch_shared_clip(&m, fuzz_rect(c));
    }
    const struct etch_vertex v[3] = {fuzz_vertex(c), fuzz_vertex(c), fuzz_vertex(c)};
    const struct etch_vertex *const p[3] = {&v[0], &v[1], &v[2]};

    ((etch_shared_painter *)f)(&m, p);
    (fuzz_byte(c) % 2 == 0 ? etch_shared_resolve : etch_shared_resolve_swapped)(&m, &c->s);
}

#define ROW(name, call)                                                                            \
    {                                                                                              \
#name, call, (fuzz_function *)name                                                         \
    }

const struct fuzz_row fuzz_frame_rows[] = {
    ROW(etch_surface_copy, copy),
    ROW(etch_surface_xor, copy),
    ROW(etch_surface_exchange, copy),
    {"etch_surface_copy_rect", copy_rect, NULL},
    {"etch_surface_scroll", scroll, NULL},
    ROW(etch_accumulation_load, accumulate),
    ROW(etch_accumulation_add, accumulate),
    ROW(etch_accumulation_return, accumulate),
    ROW(etch_accumulation_return_swapped, accumulate),
    {"etch_accumulation_multiply", multiply, NULL},
    ROW(etch_filter_average, filter),
    ROW(etch_filter_average_swapped, filter),
    ROW(etch_filter_sobel, filter),
    ROW(etch_filter_sobel_swapped, filter),
    ROW(etch_filter_draw, filter_weights),
    ROW(etch_filter_draw_swapped, filter_weights),
    ROW(etch_smooth_draw, smooth),
    ROW(etch_smooth_draw_swapped, smooth),
    ROW(etch_supersample_resolve_2, supersample_2),
    ROW(etch_supersample_resolve_2_swapped, supersample_2),
    ROW(etch_supersample_resolve_3, supersample_3),
    ROW(etch_supersample_resolve_3_swapped, supersample_3),
    ROW(etch_supersample_resolve_4, supersample_4),
    ROW(etch_supersample_resolve_4_swapped, supersample_4),
    ROW(etch_multisample_flat, multisample),
    ROW(etch_multisample_flat_less, multisample),
    ROW(etch_multisample_flat_lequal, multisample),
    ROW(etch_multisample_gouraud, multisample),
    ROW(etch_multisample_gouraud_less, multisample),
    ROW(etch_multisample_gouraud_lequal, multisample),
    ROW(etch_shared_flat, shared),
    ROW(etch_shared_flat_less, shared),
    ROW(etch_shared_flat_lequal, shared),
    ROW(etch_shared_gouraud, shared),
    ROW(etch_shared_gouraud_less, shared),
    ROW(etch_shared_gouraud_lequal, shared),
    {NULL, NULL, NULL},
};
