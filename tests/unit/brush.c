/* tests/unit: gradients, patterns, tiles and stipples against their definitions, and how they are
 * blended. */
#include "core/base/rgb565.h"
#include "core/draw/line_stipple.h"
#include "core/fragment/blend_fused.h"
#include "core/fragment/flat.h"
#include "core/fragment/gradient.h"
#include "core/fragment/pattern.h"
#include "core/fragment/write.h"
#include "core/raster/circle.h"
#include "core/raster/line.h"
#include "core/raster/line_runs.h"
#include "core/raster/rect.h"
#include "tests/harness/bands.h"

void suite_brush(void);

static struct test_canvas canvas, other;
static uint16_t table[256], entries[256];
static struct etch_ramp ramp;

/* A ramp whose entry i is i, so that colours tell entries. */
static void number_ramp(uint8_t bits)
{
    for (uint16_t i = 0; i < 256; i++)
        entries[i] = i;
    ramp.color = entries;
    ramp.bits = bits;
}

/* ---- ramps -------------------------------------------------------------------------------------
 */

static int64_t channel(const struct etch_stop *s, int32_t n, int64_t at, int32_t which,
                       int64_t most)
{
    int32_t i = 0;
    int64_t v[2], w, k;

    while (i < n && s[i].at <= at)
        i++; /* the first stop after `at` */
    for (int32_t side = 0; side < 2; side++) {
        const struct etch_stop *const p = &s[i - 1 + side < 0   ? 0
                                             : i - 1 + side < n ? i - 1 + side
                                                                : n - 1];

        v[side] = which == 0 ? p->r : which == 1 ? p->g : p->b;
    }
    if (i == 0 || i == n)
        return (2 * most * v[i == 0] + 255) / 510;
    w = s[i].at - s[i - 1].at;
    k = at - s[i - 1].at;
    return (2 * most * (v[0] * (w - k) + v[1] * k) + 255 * w) / (510 * w);
}

static void ramps_are_rounded_once(void)
{
    static uint16_t swapped[256];
    struct etch_ramp back;
    uint32_t seed = 1;

    for (int32_t i = 0; i < TEST_COUNT(400) && !test_failed(); i++) {
        const uint8_t bits = (uint8_t)test_range(&seed, 1, 8), n = (uint8_t)test_range(&seed, 1, 6);
        struct etch_stop s[6];
        int32_t at = test_range(&seed, 0, 1) * test_range(&seed, 0, 30000), wrong = 0;

        for (uint8_t k = 0; k < n; k++) {
            s[k].at = (uint16_t)at;
            s[k].r = (uint8_t)test_random(&seed);
            s[k].g = (uint8_t)test_random(&seed);
            s[k].b = (uint8_t)test_random(&seed);
            at += test_range(&seed, 0, 2) == 0 ? 0 : test_range(&seed, 0, (65535 - at) / 2);
        }
        CHECK_EQ(etch_ramp_init(&ramp, table, bits, s, n), ETCH_OK);
        CHECK_EQ(etch_ramp_init_swapped(&back, swapped, bits, s, n), ETCH_OK);
        for (int32_t k = 0; k < 1 << bits; k++) {
            const int64_t place = (2 * k + 1) * (32768 >> bits);

            wrong += ramp.color[k] !=
                     (channel(s, n, place, 0, 31) << 11 | channel(s, n, place, 1, 63) << 5 |
                      channel(s, n, place, 2, 31));
            wrong += back.color[k] != etch_rgb565_swap(ramp.color[k]);
        }
        CHECK_EQ(wrong, 0);
    }
}

static void ramps_refuse(void)
{
    static const struct etch_stop s[2] = {{5, 0, 0, 0}, {4, 0, 0, 0}};

    CHECK_EQ(etch_ramp_init(&ramp, table, 0, s, 1), ETCH_EINVAL);
    CHECK_EQ(etch_ramp_init(&ramp, table, 9, s, 1), ETCH_EINVAL);
    CHECK_EQ(etch_ramp_init(&ramp, table, 8, s, 0), ETCH_EINVAL);
    CHECK_EQ(etch_ramp_init(&ramp, table, 8, s, 2), ETCH_EINVAL);
}

/* ---- gradients ---------------------------------------------------------------------------------
 */

static int64_t held(int64_t i, int64_t most)
{
    return i < 0 ? 0 : i > most ? most : i;
}

/* A coordinate on the frame, near it, or any. */
static int16_t some(uint32_t *seed)
{
    const int32_t kind = test_range(seed, 0, 3);

    return kind == 0 ? (int16_t)test_random(seed) : (int16_t)test_range(seed, -60, kind * 150);
}

static void linear_gradients(void)
{
    uint32_t seed = 2;
    static uint16_t out[300];

    for (int32_t i = 0; i < TEST_COUNT(6000) && !test_failed(); i++) {
        const int16_t x0 = some(&seed), y0 = some(&seed);
        const int16_t x1 = i % 9 == 0 ? x0 : some(&seed), y1 = i % 9 == 1 ? y0 : some(&seed);
        const int64_t dx = x1 - (int64_t)x0, dy = y1 - (int64_t)y0, d = dx * dx + dy * dy;
        const int16_t x = (int16_t)test_range(&seed, 0, i % 5 == 0 ? 32467 : 200);
        const int16_t y = (int16_t)test_range(&seed, 0, i % 5 == 0 ? 32766 : 200);
        const uint16_t n = (uint16_t)test_range(&seed, 1, 299);
        struct etch_gradient_linear g;
        int32_t wrong = 0;

        number_ramp((uint8_t)test_range(&seed, 1, 8));
        CHECK_EQ(etch_gradient_linear_init(&g, &ramp, x0, y0, x1, y1),
                 d == 0 || d > INT32_MAX ? ETCH_EINVAL : ETCH_OK);
        if (d == 0 || d > INT32_MAX)
            continue;
        out[n] = 0xABCD;
        g.brush.colors(&g.brush, x, y, n, out);
        for (int32_t k = 0; k < n; k++) {
            const int64_t s = (x + k - x0) * dx + (y - y0) * dy, top = s * (1 << ramp.bits);

            wrong += out[k] != held(top < 0 ? -1 : top / d, (1 << ramp.bits) - 1);
        }
        if (!CHECK_EQ(wrong, 0))
            test_note("x0", x0), test_note("y0", y0), test_note("x1", x1), test_note("y1", y1);
        CHECK_EQ(out[n], 0xABCD);
    }
}

static void radial_gradients(void)
{
    uint32_t seed = 3;
    static uint16_t out[300];

    for (int32_t i = 0; i < TEST_COUNT(3000) && !test_failed(); i++) {
        const int16_t cx = some(&seed), cy = some(&seed);
        const int16_t r = (int16_t)test_range(&seed, -1, i % 3 == 0 ? 32767 : i % 3 == 1 ? 300 : 9);
        const int16_t x = (int16_t)test_range(&seed, 0, i % 5 == 0 ? 32467 : 200);
        const int16_t y = (int16_t)test_range(&seed, 0, i % 5 == 0 ? 32766 : 200);
        const uint16_t n = (uint16_t)test_range(&seed, 1, 299);
        struct etch_gradient_radial g;
        int64_t entry = 0;
        int32_t wrong = 0;

        number_ramp((uint8_t)test_range(&seed, 1, 8));
        CHECK_EQ(etch_gradient_radial_init(&g, &ramp, cx, cy, r), r < 1 ? ETCH_EINVAL : ETCH_OK);
        if (r < 1)
            continue;
        out[n] = 0xABCD;
        g.brush.colors(&g.brush, x, y, n, out);
        for (int32_t k = 0; k < n; k++) {
            const int64_t dx = x + k - cx, dy = y - cy, most = (INT64_C(1) << ramp.bits) - 1;
            const int64_t square = (dx * dx + dy * dy) * (most + 1) * (most + 1);

            while (entry > 0 && entry * entry * r * r > square)
                entry--;
            while (entry < most && (entry + 1) * (entry + 1) * r * r <= square)
                entry++;
            wrong += out[k] != entry;
        }
        if (!CHECK_EQ(wrong, 0))
            test_note("cx", cx), test_note("cy", cy), test_note("r", r);
        CHECK_EQ(out[n], 0xABCD);
    }
}

/* ---- patterns ----------------------------------------------------------------------------------
 */

static const uint8_t rows[8] = {0x80, 0x41, 0x3C, 0xFF, 0x00, 0x07, 0xA5, 0x18};

static void patterns_and_tiles(void)
{
    uint32_t seed = 4;
    static uint16_t out[300], texels[40];
    struct etch_pattern p;
    struct etch_tile t;

    etch_pattern_init(&p, rows, 11, 22);
    for (int32_t i = 0; i < TEST_COUNT(2000) && !test_failed(); i++) {
        const uint16_t w = (uint16_t)test_range(&seed, 1, 5), h = (uint16_t)test_range(&seed, 1, 6);
        const int16_t x = (int16_t)test_range(&seed, 0, 32000),
                      y = (int16_t)test_range(&seed, 0, 32766);
        const int16_t tx = (int16_t)test_random(&seed), ty = (int16_t)test_random(&seed);
        const uint16_t n = (uint16_t)test_range(&seed, 1, 299);
        int32_t wrong = 0;

        p.brush.colors(&p.brush, x, y, n, out);
        for (int32_t k = 0; k < n; k++)
            wrong += out[k] != ((rows[y % 8] & 0x80 >> (x + k) % 8) != 0 ? 22 : 11);
        for (uint16_t k = 0; k < 40; k++)
            texels[k] = k;
        CHECK_EQ(etch_tile_init(&t, texels, w, h, 6, tx, ty), ETCH_OK);
        t.brush.colors(&t.brush, x, y, n, out);
        for (int32_t k = 0; k < n; k++)
            wrong += out[k] != (y - ty + 65538 * h) % h * 6 + (x + k - tx + 65538 * w) % w;
        CHECK_EQ(wrong, 0);
    }
    CHECK_EQ(etch_tile_init(&t, NULL, 1, 1, 1, 0, 0), ETCH_EINVAL);
    CHECK_EQ(etch_tile_init(&t, texels, 0, 1, 1, 0, 0), ETCH_EINVAL);
    CHECK_EQ(etch_tile_init(&t, texels, 1, 32768, 1, 0, 0), ETCH_EINVAL);
    CHECK_EQ(etch_tile_init(&t, texels, 3, 1, 2, 0, 0), ETCH_EINVAL);
}

static const struct etch_rect window = {300, 700, 348, 744};

/* What goes through is the shape, masked; no pixel twice. */
static void stipples_are_masks(void)
{
    uint32_t seed = 5;

    for (int32_t i = 0; i < TEST_COUNT(300) && !test_failed(); i++) {
        const int16_t x = (int16_t)test_range(&seed, 290, 360),
                      y = (int16_t)test_range(&seed, 690, 750);
        const int16_t r = (int16_t)test_range(&seed, 0, 40);
        struct test_run_log log;
        const struct test_run_paint ink = test_tile_paint(&log, TEST_INK);
        const struct etch_stipple_paint stipple = {{etch_kernel_stipple}, rows, &ink.paint};
        int32_t wrong = 0;

        test_canvas_open(&canvas, window);
        test_canvas_open(&other, window);
        etch_circle_runs(&canvas.surface, x, y, r, &stipple.paint);
        CHECK(!log.broken);
        etch_circle_runs(&other.surface, x, y, r, &ink.paint);
        for (int32_t py = 700; py < 744; py++)
            for (int32_t px = 300; px < 348; px++) {
                const bool set = (rows[py & 7] & 0x80 >> (px & 7)) != 0;

                wrong += test_canvas_drawn(&canvas, px, py) !=
                         (set && test_canvas_drawn(&other, px, py));
            }
        CHECK_EQ(wrong, 0);
        CHECK_INSIDE(&canvas);
    }
}

static int32_t off(int32_t v)
{
    return v < 0 ? -v : v;
}

static void line_stipples_count_pixels(void)
{
    uint32_t seed = 6;

    for (int32_t i = 0; i < TEST_COUNT(1000) && !test_failed(); i++) {
        const bool far = i % 4 == 0;
        const int16_t x0 = far ? (int16_t)test_random(&seed) : (int16_t)test_range(&seed, 290, 360);
        const int16_t y0 = far ? (int16_t)test_random(&seed) : (int16_t)test_range(&seed, 690, 750);
        const int16_t x1 = (int16_t)test_range(&seed, 290, 360),
                      y1 = (int16_t)test_range(&seed, 690, 750);
        const uint16_t pattern = (uint16_t)test_random(&seed);
        int32_t wrong = 0;

        test_canvas_open(&canvas, window);
        test_canvas_open(&other, window);
        etch_line_stipple_draw(&canvas.surface, x0, y0, x1, y1, pattern, TEST_INK);
        etch_line_draw(&other.surface, x0, y0, x1, y1, TEST_INK);
        for (int32_t py = 700; py < 744; py++)
            for (int32_t px = 300; px < 348; px++) {
                const int32_t k = off(y1 - y0) > off(x1 - x0) ? off(py - y0) : off(px - x0);

                wrong += test_canvas_drawn(&canvas, px, py) !=
                         (test_canvas_drawn(&other, px, py) && (pattern & 0x8000 >> k % 16) != 0);
            }
        if (!CHECK_EQ(wrong, 0))
            test_note("x0", x0), test_note("y0", y0), test_note("x1", x1), test_note("y1", y1);
        CHECK_ONCE(&canvas);
    }
}

/* ---- blending ----------------------------------------------------------------------------------
 */

/* Colours that depend on the place. */
static uint16_t color_at(int32_t x, int32_t y)
{
    return (uint16_t)(x * 2654 + y * 40503 + x * y);
}

static void places(const struct etch_brush *brush, int16_t x, int16_t y, uint16_t n,
                   uint16_t *color)
{
    (void)brush;
    for (int32_t i = 0; i < n; i++)
        color[i] = color_at(x + i, y);
}
static const struct etch_brush brush = {places};

/* round((s w + d (one - w)) / one), ties upwards. */
static uint16_t mixed(uint16_t s, uint16_t d, int64_t w, int64_t one)
{
    int32_t pixel = 0;

    for (int32_t shift = 0, bits = 5; shift < 16; shift += bits, bits = shift == 5 ? 6 : 5) {
        const int64_t most = (1 << bits) - 1, from = d >> shift & most, to = s >> shift & most;

        pixel |= (int32_t)((2 * (to * w + from * (one - w)) + one) / (2 * one)) << shift;
    }
    return (uint16_t)pixel;
}

static uint16_t was_at(int32_t x, int32_t y)
{
    return (uint16_t)(x * 977 + y * 12343);
}

static void lay(struct test_canvas *c, bool swapped)
{
    test_canvas_open(c, window);
    for (int32_t y = 700; y < 744; y++)
        for (int32_t x = 300; x < 348; x++) {
            const uint16_t d = was_at(x, y);

            c->surface.pixels[etch_surface_index(&c->surface, (int16_t)x, (int16_t)y)] =
                swapped ? etch_rgb565_swap(d) : d;
        }
}

static void check_mixed(const struct test_canvas *c, bool swapped, const struct etch_rect *r,
                        int64_t w, int64_t one, int32_t flat)
{
    int32_t wrong = 0;

    for (int32_t y = 700; y < 744; y++)
        for (int32_t x = 300; x < 348; x++) {
            const bool in = x >= r->x0 && x < r->x1 && y >= r->y0 && y < r->y1;
            const uint16_t s = flat >= 0 ? (uint16_t)flat : color_at(x, y), d = was_at(x, y);
            const uint16_t expected = in ? mixed(s, d, w, one) : d;

            wrong += test_canvas_at(c, x, y) != (swapped ? etch_rgb565_swap(expected) : expected);
        }
    if (!CHECK_EQ(wrong, 0))
        test_note("w", w), test_note("swapped", swapped);
    CHECK_INSIDE(c);
}

/* Each opacity; two byte orders; a brush and one colour. */
static void opacity_is_rounded_once(void)
{
    static const struct etch_rect r = {303, 702, 344, 741};

    for (int32_t a = 0; a <= 255; a = a == 254 ? 255 : a + (TEST_DIVISOR > 1 ? 2 : 1))
        for (int32_t order = 0; order < 2; order++) {
            const struct etch_brush_paint paint = {
                {order != 0 ? etch_kernel_brush_blend_swapped : etch_kernel_brush_blend},
                &brush,
                (uint8_t)a};
            const uint16_t color = (uint16_t)(a * 257 + 12345 * order);
            struct etch_flat_blend_paint glass;

            lay(&canvas, order != 0);
            etch_rect_runs(&canvas.surface, r, &paint.paint);
            check_mixed(&canvas, order != 0, &r, a, 255, -1);
            etch_flat_blend_init(
                &glass, order != 0 ? etch_kernel_flat_blend_swapped : etch_kernel_flat_blend, color,
                (uint8_t)a);
            lay(&canvas, order != 0);
            etch_rect_runs(&canvas.surface, r, &glass.paint);
            check_mixed(&canvas, order != 0, &r, a, 255, color);
        }
}

static void brushes_replace_and_cover(void)
{
    const struct etch_rect r = {303, 702, 344, 741};
    const struct etch_brush_paint paint = {{etch_kernel_brush}, &brush, 0};
    const struct etch_stage stages[3] = {
        {etch_source_brush, &brush}, {etch_stage_write, NULL}, {NULL, NULL}};
    const struct etch_staged_paint staged = {{etch_kernel_staged}, stages};
    uint32_t seed = 7;

    lay(&canvas, false);
    etch_rect_runs(&canvas.surface, r, &paint.paint);
    check_mixed(&canvas, false, &r, 1, 1, -1);
    lay(&canvas, false);
    etch_rect_runs(&canvas.surface, r, &staged.paint);
    check_mixed(&canvas, false, &r, 1, 1, -1);
    for (int32_t i = 0; i < TEST_COUNT(400) && !test_failed(); i++) {
        const bool swapped = i % 2 != 0;
        const uint8_t opacity = (uint8_t)(i % 3 == 0 ? 255 : test_range(&seed, 0, 255));
        const struct etch_cover_brush_paint by = {
            {swapped ? etch_cover_brush_swapped : etch_cover_brush}, &brush, opacity};
        const int16_t one = (int16_t)test_range(&seed, 1, 4096);
        int16_t cover[41];

        lay(&canvas, swapped);
        for (int32_t k = 0; k < 41; k++)
            cover[k] = one;
        for (int16_t y = r.y0; y < r.y1; y++)
            by.paint.kernel(&canvas.surface, r.x0, y, 41, cover, &by.paint);
        check_mixed(&canvas, swapped, &r, (int64_t)one * opacity, 4096 * 255, -1);
    }
}

/* Each cover goes where its pixel is. */
static int32_t seen;

static void take(const struct etch_surface *s, int16_t x, int16_t y, uint16_t n,
                 const int16_t *cover, const struct etch_cover_paint *paint)
{
    (void)s, (void)paint;
    for (int32_t i = 0; i < n; i++) {
        CHECK_EQ(cover[i], x + i - 99);
        CHECK((rows[y & 7] & 0x80 >> ((x + i) & 7)) != 0);
        seen++;
    }
}

static void covers_are_stippled(void)
{
    static const struct etch_cover_paint to = {take};
    const struct etch_cover_stipple_paint paint = {{etch_cover_stipple}, rows, &to};
    int16_t cover[64];

    for (int16_t i = 0; i < 64; i++)
        cover[i] = (int16_t)(i + 1);
    for (int16_t y = 0; y < 8; y++) {
        int32_t expected = 0;

        seen = 0;
        etch_cover_stipple(&canvas.surface, 100, y, 61, cover, &paint.paint);
        for (int32_t x = 100; x < 161; x++)
            expected += (rows[y] & 0x80 >> (x & 7)) != 0;
        CHECK_EQ(seen, expected);
    }
}

void suite_brush(void)
{
    RUN(ramps_are_rounded_once);
    RUN(ramps_refuse);
    RUN(linear_gradients);
    RUN(radial_gradients);
    RUN(patterns_and_tiles);
    RUN(stipples_are_masks);
    RUN(line_stipples_count_pixels);
    RUN(opacity_is_rounded_once);
    RUN(brushes_replace_and_cover);
    RUN(covers_are_stippled);
}
