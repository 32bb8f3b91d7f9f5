/* tests/unit: text against a definition pixel by pixel, UTF-8, clips, turns, wrapping. */
#include "core/draw/text.h"

#include "core/base/rgb565.h"
#include "core/base/utf8.h"
#include "core/fonts/fonts.h"
#include "tests/harness/canvas.h"

void suite_text(void);

static struct test_canvas canvas;
static uint16_t expected[48][64];

static const struct etch_text_style styles[] = {
    {&etch_font_fixed_5x8, etch_glyph_solid, 0x1234, 0},
    {&etch_font_fixed_10x20, etch_glyph_solid, 0xF81F, 0},
    {&etch_font_fixed_9x15, etch_glyph_opaque, 0x1234, 0x4567},
    {&etch_font_sans_16_2bit, etch_glyph_blend2, 0xFD01, 0},
    {&etch_font_sans_16_2bit, etch_glyph_blend2_swapped, 0x1E77, 0},
    {&etch_font_sans_24, etch_glyph_blend4, 0x07E5, 0},
    {&etch_font_sans_12, etch_glyph_blend4_swapped, 0x8412, 0},
    {&etch_font_digits_40, etch_glyph_blend4, 0xFFFF, 0},
};
static const char *const texts[] = {
    "AVA.", "To\xC3\xA9|", "\xE2\x86\x90\xE2\x96\xB2", "17.5%", "\xFF jg_", "W", "@ \xC3"};
enum {
    STYLES = sizeof styles / sizeof styles[0],
    TEXTS = sizeof texts / sizeof texts[0]
};

/* ---- the definition ----------------------------------------------------------------------- */

static uint16_t glyph_of(const struct etch_font *f, uint32_t code)
{
    for (uint16_t i = 0; i < f->range_count; i++)
        for (uint16_t k = 0; k < f->ranges[i].count; k++)
            if (f->ranges[i].first + k == code)
                return (uint16_t)(f->ranges[i].glyph + k);
    return f->replacement;
}

static int32_t kern_of(const struct etch_font *f, uint16_t left, uint16_t right)
{
    for (uint16_t i = 0; i < f->pair_count; i++)
        if (f->pairs[i].left == left && f->pairs[i].right == right)
            return f->pairs[i].by;
    return 0;
}

/* Coverage 0 .. 15 of pixel (i, j) of a bitmap. */
static int32_t coverage(const struct etch_font *f, const struct etch_glyph *g, int32_t i, int32_t j)
{
    const int32_t pitch = (g->width * f->depth + 7) / 8, bit = i * f->depth;
    int32_t v = 0;

    for (int32_t k = bit; k < bit + f->depth; k++)
        v = 2 * v + (f->bits[g->bits + j * pitch + k / 8] >> (7 - k % 8) & 1);
    return v * 15 / ((1 << f->depth) - 1);
}

static int32_t mix(int32_t c, int32_t d, int32_t a)
{
    return (2 * (c * a + d * (15 - a)) + 15) / 30;
}

static void put(const struct etch_text_style *t, int32_t x, int32_t y, int32_t a)
{
    const struct etch_rect w = canvas.surface.window, c = canvas.surface.clip;
    const bool swap = t->painter == etch_glyph_blend2_swapped ||
                      t->painter == etch_glyph_blend4_swapped;

    if (x < c.x0 || x >= c.x1 || y < c.y0 || y >= c.y1)
        return;
    uint16_t *p = &expected[y - w.y0][x - w.x0];
    const uint16_t ink = swap ? etch_rgb565_swap(t->color) : t->color;
    const uint16_t d = swap ? etch_rgb565_swap(*p) : *p;
    const uint16_t m = (uint16_t)(mix(ink >> 11, d >> 11, a) << 11 |
                                  mix(ink >> 5 & 63, d >> 5 & 63, a) << 5 |
                                  mix(ink & 31, d & 31, a));

    if (a == 0 && t->painter == etch_glyph_opaque)
        *p = t->background;
    else
        *p = swap ? etch_rgb565_swap(m) : m;
}

/* A pixel at (u, v) from the pen's corner, turned. */
static void put_turned(const struct etch_text_style *t, int32_t x, int32_t y, int32_t u, int32_t v,
                       uint8_t quarters, int32_t a)
{
    for (; quarters != 0; quarters--) {
        const int32_t old = u;

        u = -v - 1, v = old;
    }
    put(t, x + u, y + v, a);
}

static int32_t define(const struct etch_text_style *t, int32_t x, int32_t y, uint8_t quarters,
                      const char *text)
{
    const struct etch_font *f = t->font;
    uint16_t before = ETCH_NO_GLYPH;
    int32_t pen = 0;

    while (*text != '\0') {
        const uint16_t n = glyph_of(f, etch_utf8_next(&text, NULL));

        if (n == ETCH_NO_GLYPH)
            continue;
        const struct etch_glyph *g = &f->glyphs[n];

        pen += kern_of(f, before, n);
        before = n;
        for (int32_t j = 0; j < g->height; j++)
            for (int32_t i = 0; i < g->width; i++)
                put_turned(t, x, y, pen + g->left + i, j - g->top, quarters, coverage(f, g, i, j));
        pen += g->advance;
    }
    return pen;
}

/* ---- tests -------------------------------------------------------------------------------- */

static const struct etch_rect windows[] = {
    {0, 0, 64, 48}, {100, 7, 160, 50}, {32710, 32731, 32767, 32767}};

static void open_random(int32_t i, uint32_t *seed)
{
    const struct etch_rect w = windows[i % 3];

    test_canvas_open(&canvas, w);
    if (i % 2 == 1) {
        const struct etch_rect clip = {
            (int16_t)(w.x0 + test_range(seed, 0, 30)), (int16_t)(w.y0 + test_range(seed, 0, 20)),
            (int16_t)(w.x1 - test_range(seed, 0, 30)), (int16_t)(w.y1 - test_range(seed, 0, 20))};
        test_canvas_clip(&canvas, clip);
    }
    for (int32_t y = w.y0; y < w.y1; y++)
        for (int32_t x = w.x0; x < w.x1; x++)
            expected[y - w.y0][x - w.x0] = test_canvas_at(&canvas, x, y);
}

static bool as_expected(void)
{
    const struct etch_rect w = canvas.surface.window;
    int32_t wrong = 0;

    for (int32_t y = w.y0; y < w.y1; y++)
        for (int32_t x = w.x0; x < w.x1; x++)
            wrong += test_canvas_at(&canvas, x, y) != expected[y - w.y0][x - w.x0];
    CHECK_INSIDE(&canvas);
    return CHECK_EQ(wrong, 0);
}

static void draws_what_is_defined(void)
{
    uint32_t seed = 1;

    for (int32_t i = 0; i < TEST_COUNT(4000) && !test_failed(); i++) {
        const struct etch_text_style *t = &styles[i % STYLES];
        const char *text = texts[test_range(&seed, 0, TEXTS - 1)];
        const uint8_t quarters = (uint8_t)test_range(&seed, 0, 3);
        int32_t x, y, width;

        open_random(i, &seed);
        x = canvas.surface.window.x0 + test_range(&seed, -30, 70);
        y = canvas.surface.window.y0 + test_range(&seed, -30, 70);
        x = x > INT16_MAX ? INT16_MAX : x;
        y = y > INT16_MAX ? INT16_MAX : y;
        width = etch_text_draw_turned(&canvas.surface, t, (int16_t)x, (int16_t)y, quarters, text,
                                      NULL);
        CHECK_EQ(width, define(t, x, y, quarters, text));
        CHECK_EQ(width, etch_text_width(t->font, text, NULL));
        if (!as_expected())
            test_note("style", i % STYLES), test_note("quarters", quarters);
    }
}

static void bounds_are_what_is_drawn(void)
{
    for (int32_t i = 0; i < STYLES * TEXTS; i++) {
        const struct etch_text_style *t = &styles[i % STYLES];
        const char *text = texts[i / STYLES];
        const struct etch_rect b = etch_text_bounds(t->font, text, NULL);
        struct etch_rect seen = {64, 48, 0, 0};
        bool none = true;

        test_canvas_open(&canvas, windows[0]);
        etch_text_draw(&canvas.surface, t, 4, 36, text, NULL);
        for (int16_t y = 0; y < 48; y++) {
            for (int16_t x = 0; x < 64; x++) {
                if (test_canvas_drawn(&canvas, x, y)) {
                    none = false;
                    seen.x0 = x < seen.x0 ? x : seen.x0, seen.y0 = y < seen.y0 ? y : seen.y0;
                    seen.x1 = x >= seen.x1 ? (int16_t)(x + 1) : seen.x1;
                    seen.y1 = y >= seen.y1 ? (int16_t)(y + 1) : seen.y1;
                }
            }
        }
        if (b.x0 + 4 < 0 || b.x1 + 4 > 64 || b.y1 + 36 > 48)
            continue; /* cut by the window: the definition above has it */
        if (!none) {
            CHECK_EQ(seen.x0, b.x0 + 4);
            CHECK_EQ(seen.x1, b.x1 + 4);
            CHECK_EQ(seen.y0, b.y0 + 36);
            CHECK_EQ(seen.y1, b.y1 + 36);
        } else {
            CHECK(b.x1 == b.x0);
        }
    }
}

static void stands_on_the_baseline(void)
{
    const struct etch_text_style t = {&etch_font_fixed_5x8, etch_glyph_solid, 0xFFFF, 0};
    const struct etch_rect w = {0, 0, 11, 8};

    test_canvas_open(&canvas, w);
    etch_text_draw(&canvas.surface, &t, 0, 6, "Hj", NULL);
    CHECK_PICTURE(&canvas, "#..#....#.."
                           "#..#......."
                           "####....#.."
                           "#..#....#.."
                           "#..#....#.."
                           "#..#..#.#.."
                           ".......#..."
                           "...........");
}

static void cells_once(void)
{
    const struct etch_text_style t = {&etch_font_fixed_9x15, etch_glyph_opaque, 7, 9};
    uint32_t seed = 3;

    for (int32_t i = 0; i < TEST_COUNT(300) && !test_failed(); i++) {
        const char *text = texts[i % TEXTS];
        int32_t x, y, width;

        open_random(i, &seed);
        x = canvas.surface.window.x0 + test_range(&seed, -20, 50);
        y = canvas.surface.window.y0 + test_range(&seed, -10, 50);
        x = x > INT16_MAX ? INT16_MAX : x;
        y = y > INT16_MAX ? INT16_MAX : y;
        width = etch_text_width(t.font, text, NULL);
        for (int32_t j = y - t.font->ascent; j < y + t.font->descent; j++)
            for (int32_t k = x; k < x + width; k++)
                put(&t, k, j, 0);
        define(&t, x, y, 0, text);
        CHECK_EQ(etch_text_draw_cells(&canvas.surface, &t, (int16_t)x, (int16_t)y, text, NULL),
                 width);
        as_expected();
        CHECK_ONCE(&canvas);
    }
}

static void check_utf8(const char *text, const uint32_t *codes, int32_t n)
{
    const char *end = text;

    while (*end != '\0')
        end++;
    for (const char *p = text; n-- > 0; codes++)
        CHECK(!etch_utf8_ended(p, end) && etch_utf8_next(&p, end) == *codes &&
              (n != 0 || p == end));
}

static void decodes_utf8(void)
{
    static const uint32_t good[] = {'a', 0x80, 0x7FF, 0x800, 0xFFFF, 0x10000, 0x10FFFF};
    static const uint32_t bad[] = {0xFFFD, 0xFFFD, 0xFFFD, 0xFFFD, 0xFFFD, 0xFFFD, 0xFFFD, 0xFFFD};
    static const uint32_t cut[] = {0xFFFD, 'b', 0xFFFD};

    check_utf8("a\xC2\x80\xDF\xBF\xE0\xA0\x80\xEF\xBF\xBF\xF0\x90\x80\x80\xF4\x8F\xBF\xBF", good,
               7);
    check_utf8("\xC0\x80\xE0\x80\x80\xED\xA0\x80", bad, 8); /* overlong, surrogate */
    check_utf8("\xF4\x90\x80\x80\xF5\x80\xFF\x80", bad, 8); /* too large, never */
    check_utf8("\xF0\x9F\x98"
               "b"
               "\xE2\x82",
               cut, 3); /* cut: one for each longest part */
}

/* Every code point encoded, decodes; with its last byte cut off it is bad and nothing beyond is
 * read. */
static void decodes_all(void)
{
    for (uint32_t code = 0x80; code < 0x110000; code += code < 0x1000 ? 1 : 37) {
        char b[4];
        int32_t n = 0;

        if (code >= 0xD800 && code < 0xE000)
            continue;
        if (code < 0x800)
            b[n++] = (char)(code >> 6 | 0xC0);
        else if (code < 0x10000)
            b[n++] = (char)(code >> 12 | 0xE0), b[n++] = (char)((code >> 6 & 63) | 0x80);
        else
            b[n++] = (char)(code >> 18 | 0xF0), b[n++] = (char)((code >> 12 & 63) | 0x80),
            b[n++] = (char)((code >> 6 & 63) | 0x80);
        b[n++] = (char)((code & 63) | 0x80);
        const char *p = b, *q = b;

        if (!CHECK(etch_utf8_next(&p, b + n) == code && p == b + n) ||
            !CHECK(etch_utf8_next(&q, b + n - 1) == ETCH_UTF8_BAD && q == b + n - 1))
            return;
    }
}

static void check_line(struct etch_text_line l, const char *begin, int32_t n, const char *next)
{
    CHECK(l.begin == begin && l.end - l.begin == n && l.next == next);
    CHECK_EQ(l.width, etch_text_width(&etch_font_fixed_5x8, l.begin, l.end));
}

static void wraps(void)
{
    const struct etch_font *f = &etch_font_fixed_5x8;
    const char *a = "one two  three\n\nfour", *b = "longword x", *c = "a  ";

    check_line(etch_text_break(f, 35, a, NULL), a, 7, a + 9);
    check_line(etch_text_break(f, 34, a, NULL), a, 3, a + 4);
    check_line(etch_text_break(f, 35, a + 9, NULL), a + 9, 5, a + 15);
    check_line(etch_text_break(f, 35, a + 15, NULL), a + 15, 0, a + 16);
    check_line(etch_text_break(f, 12, b, NULL), b, 2, b + 2);
    check_line(etch_text_break(f, -5, b, NULL), b, 1, b + 1);
    check_line(etch_text_break(f, 99, c, NULL), c, 1, c + 3);
    CHECK_EQ(etch_text_lines(f, 35, a, NULL), 4);
    CHECK_EQ(etch_text_lines(f, -1, b, NULL), 9);
    CHECK_EQ(etch_text_lines(f, 9, "", NULL), 0);
}

/* A box is its lines, each aligned, and nothing outside. */
static void boxes(void)
{
    const struct etch_text_style t = {&etch_font_fixed_5x8, etch_glyph_solid, 0xFFFF, 0};
    const struct etch_rect box = {3, 5, 44, 27}, left = {3, 5, 44, 13};
    static const int16_t from[] = {3, 3 + (41 - 35) / 2, 44 - 35};

    for (int32_t align = 0; align < 3; align++) {
        test_canvas_open(&canvas, windows[0]);
        CHECK_EQ(etch_text_box(&canvas.surface, &t, box, (enum etch_align)align,
                               "one two three four five six seven", NULL),
                 3);
        for (int32_t y = 0; y < 48; y++)
            for (int32_t x = 0; x < 64; x++)
                expected[y][x] = test_canvas_at(&canvas, x, y);
        for (int32_t y = 0; y < 48; y++)
            for (int32_t x = 0; x < 64; x++)
                if (x < 3 || x >= 44 || y < 5 || y >= 27)
                    CHECK(!test_canvas_drawn(&canvas, x, y));
        test_canvas_clip(&canvas, left);
        CHECK_EQ(etch_text_draw(&canvas.surface, &t, from[align], (int16_t)(5 + t.font->ascent),
                                "one two", NULL),
                 35);
        for (int32_t y = 5; y < 13; y++)
            for (int32_t x = 3; x < 44; x++)
                CHECK(expected[y][x] == test_canvas_at(&canvas, x, y));
    }
}

static void aligns(void)
{
    const struct etch_text_style t = {&etch_font_sans_16, etch_glyph_blend4, 0xFFFF, 0};

    for (int32_t align = 0; align < 3; align++) {
        const int32_t w = etch_text_width(t.font, "AVT", NULL);
        const int32_t from = 40 - (align == 0 ? 0 : align == 1 ? (w + 1) / 2 : w);

        test_canvas_open(&canvas, windows[0]);
        CHECK_EQ(etch_text_draw_aligned(&canvas.surface, &t, 40, 20, (enum etch_align)align, "AVT",
                                        NULL),
                 w);
        const uint32_t hash = test_canvas_hash(&canvas);

        test_canvas_wipe(&canvas);
        etch_text_draw(&canvas.surface, &t, (int16_t)from, 20, "AVT", NULL);
        CHECK_EQ(hash, test_canvas_hash(&canvas));
    }
}

static void takes_every_pen(void)
{
    static const int16_t at[] = {INT16_MIN, -1, 0, INT16_MAX};
    static struct etch_font none;

    for (int32_t i = 0; i < 16 * STYLES; i++) {
        open_random(i, &(uint32_t){5});
        for (uint8_t q = 0; q < 4; q++)
            etch_text_draw_turned(&canvas.surface, &styles[i / 16], at[i & 3], at[i >> 2 & 3], q,
                                  "ABgj\xC3\xA9", NULL);
        etch_text_draw_cells(&canvas.surface, &styles[2], at[i & 3], at[i >> 2 & 3], "ABgj", NULL);
        CHECK_INSIDE(&canvas);
    }
    none = etch_font_fixed_5x8_ascii;
    none.replacement = ETCH_NO_GLYPH;
    CHECK_EQ(etch_text_width(&none,
                             "a\xC3\xA9\xFF"
                             "b",
                             NULL),
             10);
    CHECK_EQ(etch_text_width(&etch_font_fixed_5x8_ascii,
                             "a\xC3\xA9\xFF"
                             "b",
                             NULL),
             20);
    none.range_count = 0;
    CHECK_EQ(etch_text_width(&none, "ab", NULL), 0);
}

void suite_text(void)
{
    RUN(draws_what_is_defined);
    RUN(bounds_are_what_is_drawn);
    RUN(stands_on_the_baseline);
    RUN(cells_once);
    RUN(decodes_utf8);
    RUN(decodes_all);
    RUN(wraps);
    RUN(boxes);
    RUN(aligns);
    RUN(takes_every_pen);
}
