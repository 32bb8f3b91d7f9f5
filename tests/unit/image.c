/* tests/unit: images of every format, drawn in every way, against definitions pixel by pixel. */
#include "core/draw/image.h"

#include "core/base/rgb565.h"
#include "tests/harness/canvas.h"

void suite_image(void);

enum how {
    COPY,
    KEY,
    KEY_COLOR,
    FADE,
    PLANE, /* alpha plane of 8 bits */
    MASK8,
    MASK4,
    XOR
};

static const struct kind {
    etch_image_row *row;
    uint8_t bits;
    enum how how;
    bool swapped;
} kinds[] = {
    {etch_row_rgb565, 16, COPY, false},
    {etch_row_rgb565_key, 16, KEY_COLOR, false},
    {etch_row_rgb565_fade, 16, FADE, false},
    {etch_row_rgb565_fade_swapped, 16, FADE, true},
    {etch_row_rgb565_alpha, 16, PLANE, false},
    {etch_row_rgb565_alpha_swapped, 16, PLANE, true},
    {etch_row_index8, 8, COPY, false},
    {etch_row_index8_key, 8, KEY, false},
    {etch_row_index8_fade, 8, FADE, false},
    {etch_row_index8_fade_swapped, 8, FADE, true},
    {etch_row_index4, 4, COPY, false},
    {etch_row_index4_key, 4, KEY, false},
    {etch_row_index4_fade, 4, FADE, false},
    {etch_row_index4_fade_swapped, 4, FADE, true},
    {etch_row_index2, 2, COPY, false},
    {etch_row_index2_key, 2, KEY, false},
    {etch_row_index2_fade, 2, FADE, false},
    {etch_row_index2_fade_swapped, 2, FADE, true},
    {etch_row_index1, 1, COPY, false},
    {etch_row_index1_key, 1, KEY, false},
    {etch_row_index1_xor, 1, XOR, false},
    {etch_row_index1_fade, 1, FADE, false},
    {etch_row_index1_fade_swapped, 1, FADE, true},
    {etch_row_mask8, 8, MASK8, false},
    {etch_row_mask8_swapped, 8, MASK8, true},
    {etch_row_mask4, 8, MASK4, false},
    {etch_row_mask4_swapped, 8, MASK4, true},
};
enum {
    KINDS = sizeof kinds / sizeof kinds[0],
    TEXELS = 1200
};

static struct test_canvas canvas;
static uint16_t expected[48][64];
static uint16_t texels[TEXELS], palette[256];
static uint8_t alpha[TEXELS];
static struct etch_image image;
static const struct kind *kind;
static struct etch_image_style style;

static const struct etch_rect windows[] = {
    {0, 0, 64, 48}, {100, 7, 160, 50}, {32710, 32731, 32767, 32767}};

/* ---- the definition ----------------------------------------------------------------------- */

static uint32_t raw(const uint8_t *bytes, int32_t place, int32_t bits)
{
    uint32_t v = 0;

    for (int32_t k = 0; k < bits; k++)
        v |= (uint32_t)(bytes[(place * bits + k) / 8] >> (place * bits + k) % 8 & 1) << k;
    return v;
}

static uint32_t nearest(uint32_t n, uint32_t d)
{
    return (2 * n + d) / (2 * d);
}

static uint16_t mixed(uint16_t c, uint16_t d, uint32_t a, bool swapped)
{
    if (swapped)
        c = etch_rgb565_swap(c), d = etch_rgb565_swap(d);
    const uint32_t r = nearest((c >> 11) * a + (d >> 11) * (255 - a), 255);
    const uint32_t g = nearest((c >> 5 & 63U) * a + (d >> 5 & 63U) * (255 - a), 255);
    const uint32_t b = nearest((c & 31U) * a + (d & 31U) * (255 - a), 255);
    const uint16_t out = (uint16_t)(r << 11 | g << 5 | b);

    return swapped ? etch_rgb565_swap(out) : out;
}

static uint16_t defined(int32_t u, int32_t v, uint16_t there)
{
    const int32_t place = v * image.stride + u;
    const uint32_t value = kind->bits == 16 ? texels[place]
                                            : raw((const uint8_t *)texels, place, kind->bits);
    const uint16_t color = kind->bits == 16 ? (uint16_t)value : palette[value];

    switch (kind->how) {
    case COPY: return color;
    case KEY: return value == 0 ? there : color;
    case KEY_COLOR: return value == palette[0] ? there : color;
    case FADE: return mixed(color, there, style.opacity, kind->swapped);
    case PLANE:
        return mixed(color, there, nearest((uint32_t)alpha[place] * style.opacity, 255),
                     kind->swapped);
    case MASK8:
        return mixed(palette[0], there, nearest((uint32_t)alpha[place] * style.opacity, 255),
                     kind->swapped);
    case MASK4:
        return mixed(palette[0], there, nearest(raw(alpha, place, 4) * 17 * style.opacity, 255),
                     kind->swapped);
    default: return value == 0 ? there : (uint16_t)(there ^ palette[1]);
    }
}

/* Texel (u, v), if there is one, at pixel (x, y), if it may be written. */
static void put(int32_t x, int32_t y, int32_t u, int32_t v)
{
    const struct etch_rect w = canvas.surface.window, c = canvas.surface.clip;

    if (x >= c.x0 && x < c.x1 && y >= c.y0 && y < c.y1 && u >= 0 && u < image.width && v >= 0 &&
        v < image.height)
        expected[y - w.y0][x - w.x0] = defined(u, v, expected[y - w.y0][x - w.x0]);
}

/* ---- samples ------------------------------------------------------------------------------ */

static void make_image(int32_t i, uint32_t *seed)
{
    kind = &kinds[i % KINDS];
    for (int32_t k = 0; k < TEXELS; k++) {
        const uint32_t v = test_random(seed);

        texels[k] = (uint16_t)v;
        alpha[k] = (uint8_t)((v >> 24 & 3) == 0 ? 0 : (v >> 24 & 3) == 1 ? 255 : v >> 16 & 255);
    }
    for (int32_t k = 0; k < 256; k++)
        palette[k] = (uint16_t)test_random(seed);
    palette[0] = (i & 1) == 0 ? texels[5] : palette[0];
    image = (struct etch_image){.texels = texels,
                                .palette = palette,
                                .alpha = alpha,
                                .width = (uint16_t)test_range(seed, 1, 30),
                                .height = (uint16_t)test_range(seed, 1, 30)};
    image.stride = (uint16_t)(image.width + test_range(seed, 0, 9));
    style = (struct etch_image_style){&image, kind->row, (uint8_t)test_range(seed, -60, 255)};
    style.opacity = test_range(seed, 0, 2) == 0 ? 255 : style.opacity;
}

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

static void make(int32_t i, uint32_t *seed)
{
    make_image(i, seed);
    open_random(i, seed);
}

static int16_t near_x(uint32_t *seed)
{
    const int32_t x = canvas.surface.window.x0 + test_range(seed, -40, 70);

    return (int16_t)(x > INT16_MAX ? INT16_MAX : x);
}

static int16_t near_y(uint32_t *seed)
{
    const int32_t y = canvas.surface.window.y0 + test_range(seed, -40, 60);

    return (int16_t)(y > INT16_MAX ? INT16_MAX : y);
}

static bool as_expected(int32_t i)
{
    const struct etch_rect w = canvas.surface.window;
    int32_t wrong = 0;

    for (int32_t y = w.y0; y < w.y1; y++)
        for (int32_t x = w.x0; x < w.x1; x++)
            wrong += test_canvas_at(&canvas, x, y) != expected[y - w.y0][x - w.x0];
    CHECK_ONCE(&canvas);
    if (!CHECK_EQ(wrong, 0))
        test_note("i", i), test_note("kind", i % KINDS);
    return wrong == 0;
}

/* ---- tests -------------------------------------------------------------------------------- */

static void parts_are_their_texels(void)
{
    uint32_t seed = 1;

    for (int32_t i = 0; i < TEST_COUNT(2700) && !test_failed(); i++) {
        make(i, &seed);
        const int16_t x = near_x(&seed), y = near_y(&seed);
        const struct etch_rect part = {
            (int16_t)test_range(&seed, -9, 20), (int16_t)test_range(&seed, -9, 20),
            (int16_t)test_range(&seed, 5, 35), (int16_t)test_range(&seed, 5, 35)};

        for (int32_t v = part.y0; v < part.y1; v++)
            for (int32_t u = part.x0; u < part.x1; u++)
                put(x + u - part.x0, y + v - part.y0, u, v);
        etch_image_draw_part(&canvas.surface, &style, part, x, y);
        as_expected(i);
    }
}

/* Mirrored, then turned quarter by quarter: (u, v) of h rows goes to (h - 1 - v, u). */
static void turns_are_their_quarters(void)
{
    uint32_t seed = 2;

    for (int32_t i = 0; i < TEST_COUNT(2700) && !test_failed(); i++) {
        const int32_t turn = test_range(&seed, 0, 7);

        make(i, &seed);
        const int16_t x = near_x(&seed), y = near_y(&seed);

        for (int32_t v = 0; v < image.height; v++) {
            for (int32_t u = 0; u < image.width; u++) {
                int32_t a = turn >= 4 ? image.width - 1 - u : u, b = v;
                int32_t w = image.width, h = image.height;

                for (int32_t k = 0; k < turn % 4; k++) {
                    const int32_t old = a, wide = w;

                    a = h - 1 - b, b = old;
                    w = h, h = wide;
                }
                put(x + a, y + b, u, v);
            }
        }
        etch_image_draw_turned(&canvas.surface, &style, x, y, (enum etch_turn)turn);
        if (!as_expected(i))
            test_note("turn", turn);
    }
}

static int32_t nearest_texel(int32_t i, int32_t n, int32_t w)
{
    return (int32_t)((2 * (int64_t)i + 1) * n / (2 * (int64_t)w));
}

static int16_t some_size(int32_t i, uint32_t *seed)
{
    return (int16_t)(i % 5 == 0   ? test_range(seed, -3, 32767)
                     : i % 5 == 1 ? test_range(seed, 0, 3)
                                  : test_range(seed, 1, 90));
}

static void scales_are_exact(void)
{
    uint32_t seed = 3;

    for (int32_t i = 0; i < TEST_COUNT(2700) && !test_failed(); i++) {
        make(i, &seed);
        const struct etch_rect part = {
            (int16_t)test_range(&seed, -5, 10), (int16_t)test_range(&seed, -5, 10),
            (int16_t)test_range(&seed, 5, 35), (int16_t)test_range(&seed, 5, 35)};
        const struct etch_rect in = etch_rect_intersect(part, etch_image_whole(&image));
        const struct etch_rect c = canvas.surface.window;
        const int16_t w = some_size(i, &seed), h = some_size(i / 5, &seed);
        const int16_t x = (int16_t)(near_x(&seed) - (w > 90 ? test_range(&seed, 0, w) : 0));
        const int16_t y = (int16_t)(near_y(&seed) - (h > 90 ? test_range(&seed, 0, h) : 0));

        for (int32_t py = c.y0; py < c.y1 && !etch_rect_is_empty(in); py++)
            for (int32_t px = c.x0; px < c.x1; px++)
                if (px >= x && px < x + w && py >= y && py < y + h)
                    put(px, py, in.x0 + nearest_texel(px - x, in.x1 - in.x0, w),
                        in.y0 + nearest_texel(py - y, in.y1 - in.y0, h));
        etch_image_draw_scaled(&canvas.surface, &style, part, x, y, w, h);
        if (!as_expected(i))
            test_note("w", w), test_note("h", h);
    }
}

/* The steps of scaling against the exact quotient for large images and rectangles. */
static void scales_of_any_size_are_exact(void)
{
    uint32_t seed = 4;

    for (int32_t i = 0; i < TEST_COUNT(20000) && !test_failed(); i++) {
        const int32_t n = i % 3 == 0 ? test_range(&seed, 32700, 32767)
                                     : test_range(&seed, 1, 32767);
        const int32_t w = i % 4 == 0 ? test_range(&seed, 32700, 32767)
                                     : test_range(&seed, 1, 32767);
        const int32_t k = i % 5 == 0 ? w - 1 : test_range(&seed, 0, w - 1);
        const int32_t x = test_range(&seed, INT16_MIN, INT16_MAX - k);
        const struct etch_rect from = {0, 0, (int16_t)n, (int16_t)n};
        struct etch_map map;

        etch_map_scale(&map, from, (int16_t)x, (int16_t)x, (int16_t)w, (int16_t)w);
        CHECK_EQ((map.u + map.ux * (x + k)) >> 32, nearest_texel(k, n, w));
        if (!CHECK_EQ((map.v + map.vy * (x + k)) >> 32, nearest_texel(k, n, w)))
            test_note("n", n), test_note("w", w), test_note("k", k);
    }
}

/* The texel of pixel k of w. */
static int32_t nine_texel(int32_t k, int32_t n, int32_t near, int32_t far, int32_t w)
{
    near = near < n ? near : n;
    far = far < n - near ? far : n - near;
    const int32_t head = w < near + far ? w * near / (near + far) : near;
    const int32_t tail = w < near + far ? w - head : far;

    if (k < head)
        return k;
    if (k >= w - tail)
        return n - (w - k);
    return near + far == n ? -1 : near + nearest_texel(k - head, n - near - far, w - head - tail);
}

static void nine_patches_keep_their_borders(void)
{
    uint32_t seed = 5;

    for (int32_t i = 0; i < TEST_COUNT(1800) && !test_failed(); i++) {
        make(i, &seed);
        const struct etch_border border = {
            (uint16_t)test_range(&seed, 0, 14), (uint16_t)test_range(&seed, 0, 14),
            (uint16_t)test_range(&seed, 0, 14),
            (uint16_t)(i % 9 == 0 ? 65535 : test_range(&seed, 0, 14))};
        const struct etch_rect c = canvas.surface.window;
        const int16_t w = some_size(i, &seed), h = some_size(i / 5, &seed);
        const int16_t x = near_x(&seed), y = near_y(&seed);

        for (int32_t py = c.y0; py < c.y1; py++)
            for (int32_t px = c.x0; px < c.x1; px++)
                if (px >= x && px < x + w && py >= y && py < y + h)
                    put(px, py, nine_texel(px - x, image.width, border.left, border.right, w),
                        nine_texel(py - y, image.height, border.top, border.bottom, h));
        etch_image_draw_nine(&canvas.surface, &style, &border, x, y, w, h);
        if (!as_expected(i))
            test_note("w", w), test_note("h", h);
    }
}

/* A map of every kind: turned, sheared, made by hand. */
static struct etch_map some_map(int32_t i, uint32_t *seed)
{
    const struct etch_rect all = {-3, -2, (int16_t)(image.width + i % 3 - 1), 40};
    const struct etch_rect w = canvas.surface.window;
    const int32_t one = 65536;
    struct etch_map m;

    if (i % 3 == 0) {
        const struct etch_map_place place = {
            test_range(seed, -5 * one, 35 * one),
            test_range(seed, -5 * one, 35 * one),
            w.x0 * one + test_range(seed, -9 * one, one),
            w.y0 * one + test_range(seed, -9 * one, one),
            (uint16_t)(i % 4 == 0 ? test_range(seed, 0, 3) << 14 : test_range(seed, 0, 65535)),
            test_range(seed, -4 * one, 4 * one),
            test_range(seed, -4 * one, 4 * one)};

        (void)etch_map_rotate(&m, all, &place);
    } else if (i % 3 == 1) {
        const int32_t most = i % 7 == 0 ? INT32_MAX : 3 * one;
        const struct etch_affine a = {test_range(seed, -most, most),
                                      test_range(seed, -most, most),
                                      w.x0 * one + test_range(seed, -9 * one, one),
                                      test_range(seed, -most, most),
                                      test_range(seed, -most, most),
                                      w.y0 * one + test_range(seed, -9 * one, one)};

        (void)etch_map_invert(&m, all, &a);
    } else {
        const int64_t step = INT64_C(1) << test_range(seed, 20, 45);
        const struct etch_rect bounds = {(int16_t)near_x(seed), (int16_t)near_y(seed), 32767,
                                         32767};

        m = (struct etch_map){0, 0, 0, 0, 0, 0, all, bounds};
        m.ux = step / 64 * test_range(seed, -64, 64), m.uy = step / 64 * test_range(seed, -64, 64);
        m.vx = step / 64 * test_range(seed, -64, 64), m.vy = step / 64 * test_range(seed, -64, 64);
        m.u = -m.ux * near_x(seed) - m.uy * near_y(seed);
        m.v = -m.vx * near_x(seed) - m.vy * near_y(seed);
    }
    return m;
}

static void maps_show_the_texel_at_each_centre(void)
{
    uint32_t seed = 6;
    int64_t shown = 0;

    for (int32_t i = 0; i < TEST_COUNT(5400) && !test_failed(); i++) {
        make(i, &seed);
        const struct etch_map m = some_map(i, &seed);
        const struct etch_rect c = canvas.surface.clip;

        for (int32_t y = c.y0; y < c.y1; y++) {
            for (int32_t x = c.x0; x < c.x1; x++) {
                const int64_t u = (m.u + m.ux * x + m.uy * y) >> 32;
                const int64_t v = (m.v + m.vx * x + m.vy * y) >> 32;

                if (x >= m.bounds.x0 && x < m.bounds.x1 && y >= m.bounds.y0 && y < m.bounds.y1 &&
                    u >= m.from.x0 && u < m.from.x1 && v >= m.from.y0 && v < m.from.y1)
                    put(x, y, (int32_t)u, (int32_t)v), shown++;
            }
        }
        etch_image_draw_mapped(&canvas.surface, &style, &m);
        as_expected(i);
    }
    CHECK(test_failed() || shown > TEST_COUNT(5400) * 50);
}

/* A quarter turn about a pixel's corner is the turn by texels; the bounds cut nothing off. */
static void quarter_turns_are_turns(void)
{
    uint32_t seed = 7;

    for (int32_t i = 0; i < TEST_COUNT(540) && !test_failed(); i++) {
        const int32_t quarters = i % 4, one = 65536;
        struct etch_map m;

        make(i, &seed);
        const int32_t x = canvas.surface.window.x0 + 20, y = canvas.surface.window.y0 + 10;
        const int32_t w = image.width, h = image.height;
        const int32_t to_x = x + (quarters == 1 ? h : 0) + (quarters == 2 ? w : 0);
        const int32_t to_y = y + (quarters == 2 ? h : 0) + (quarters == 3 ? w : 0);

        if (to_x > INT16_MAX || to_y > INT16_MAX)
            continue; /* 16.16 ends there */
        const uint16_t angle = (uint16_t)(quarters << 14);
        const struct etch_map_place place = {0, 0, to_x * one, to_y * one, angle, one, one};

        CHECK_EQ(etch_map_rotate(&m, etch_image_whole(&image), &place), ETCH_OK);
        etch_image_draw_turned(&canvas.surface, &style, (int16_t)x, (int16_t)y,
                               (enum etch_turn)quarters);
        for (int32_t k = 0; k < 48 * 64; k++) {
            const struct etch_rect c = canvas.surface.window;

            if (k / 64 < c.y1 - c.y0 && k % 64 < c.x1 - c.x0)
                expected[k / 64][k % 64] = test_canvas_at(&canvas, c.x0 + k % 64, c.y0 + k / 64);
        }
        test_canvas_wipe(&canvas);
        etch_image_draw_mapped(&canvas.surface, &style, &m);
        as_expected(i);
    }
}

/* invert(forward) leads back, and its bounds hold what is drawn. */
static void inverses_lead_back(void)
{
    const int32_t one = 65536;
    uint32_t seed = 8;

    for (int32_t i = 0; i < TEST_COUNT(20000) && !test_failed(); i++) {
        const struct etch_rect from = {0, 0, 64, 64};
        const struct etch_affine a = {
            test_range(&seed, -3 * one, 3 * one),   test_range(&seed, -3 * one, 3 * one),
            test_range(&seed, -99 * one, 99 * one), test_range(&seed, -3 * one, 3 * one),
            test_range(&seed, -3 * one, 3 * one),   test_range(&seed, -99 * one, 99 * one)};
        const int64_t determinant = (int64_t)a.xu * a.yv - (int64_t)a.xv * a.yu;
        const int64_t u = test_range(&seed, 0, 64 * one - 1),
                      v = test_range(&seed, 0, 64 * one - 1);
        const int64_t x = ((a.xu * u + a.xv * v) >> 16) + a.x0;
        const int64_t y = ((a.yu * u + a.yv * v) >> 16) + a.y0;
        struct etch_map m;

        if (determinant / one < one / 4 && determinant / one > -one / 4)
            continue; /* nearly flat: steps err more than this test allows */
        CHECK_EQ(etch_map_invert(&m, from, &a), ETCH_OK);
        CHECK(m.bounds.x0 * INT64_C(65536) <= x && x <= m.bounds.x1 * INT64_C(65536));
        CHECK(m.bounds.y0 * INT64_C(65536) <= y && y <= m.bounds.y1 * INT64_C(65536));
        /* steps err by 2^-17 over |x|, |y| < 600, x and y by 2^-16 times a step of at most 24 */
        const int64_t back_u = (m.u >> 16) +
                               (m.ux / one * (x - one / 2) + m.uy / one * (y - one / 2)) / one;
        const int64_t back_v = (m.v >> 16) +
                               (m.vx / one * (x - one / 2) + m.vy / one * (y - one / 2)) / one;

        if (!CHECK(back_u - u < 700 && u - back_u < 700 && back_v - v < 700 && v - back_v < 700))
            test_note("i", i);
    }
}

static void maps_that_cannot_be_draw_nothing(void)
{
    const struct etch_rect from = {0, 0, 9, 9}, none = {3, 3, 3, 9};
    const int32_t one = 65536;
    struct etch_map_place place = {0, 0, one, one, 99, 7, one};
    struct etch_affine flat = {one, one, 0, 2 * one, 2 * one, 0};
    struct etch_affine wide = {INT32_MIN, 0, 0, 0, one, 0};
    struct etch_affine tiny = {7, 0, 0, 0, one, 0};
    struct etch_map m;

    test_canvas_open(&canvas, windows[0]);
    make_image(0, &(uint32_t){9});
    CHECK_EQ(etch_map_rotate(&m, from, &place), ETCH_EINVAL);
    etch_image_draw_mapped(&canvas.surface, &style, &m);
    place.scale_u = 8;
    CHECK_EQ(etch_map_rotate(&m, none, &place), ETCH_EINVAL);
    etch_image_draw_mapped(&canvas.surface, &style, &m);
    CHECK_EQ(etch_map_rotate(&m, from, &place), ETCH_OK);
    CHECK_EQ(etch_map_invert(&m, from, &flat), ETCH_EINVAL);
    etch_image_draw_mapped(&canvas.surface, &style, &m);
    CHECK_EQ(etch_map_invert(&m, from, &wide), ETCH_EINVAL);
    etch_image_draw_mapped(&canvas.surface, &style, &m);
    CHECK_EQ(etch_map_invert(&m, from, &tiny), ETCH_EINVAL);
    etch_image_draw_mapped(&canvas.surface, &style, &m);
    etch_map_scale(&m, from, 0, 0, 0, 9);
    etch_image_draw_mapped(&canvas.surface, &style, &m);
    etch_map_scale(&m, none, 0, 0, 9, 9);
    etch_image_draw_mapped(&canvas.surface, &style, &m);
    image.width = 0;
    etch_image_draw(&canvas.surface, &style, 3, 3);
    etch_image_draw_turned(&canvas.surface, &style, 3, 3, ETCH_TURN_LEFT);
    image.width = 40000; /* beyond the range: no texel */
    etch_image_draw_scaled(&canvas.surface, &style, etch_image_whole(&image), 3, 3, 9, 9);
    for (int32_t y = 0; y < 48; y++)
        for (int32_t x = 0; x < 64; x++)
            CHECK(!test_canvas_drawn(&canvas, x, y));
}

static void an_xor_cursor_takes_itself_away(void)
{
    static const uint8_t bits[] = {0x1F, 0x07, 0x07, 0x19, 0x31}; /* an arrow, low bits first */
    static const uint16_t ink[] = {0, 0xE71C};
    const struct etch_image arrow = {
        .texels = bits, .palette = ink, .width = 6, .height = 5, .stride = 8};
    const struct etch_image_style cursor = {&arrow, etch_row_index1_xor, 255};
    const struct etch_rect w = {0, 0, 8, 6};

    test_canvas_open(&canvas, w);
    etch_image_draw(&canvas.surface, &cursor, 1, 0);
    CHECK_PICTURE(&canvas, ".#####.."
                           ".###...."
                           ".###...."
                           ".#..##.."
                           ".#...##."
                           "........");
    etch_image_draw(&canvas.surface, &cursor, 1, 0);
    CHECK_PICTURE(&canvas, "........"
                           "........"
                           "........"
                           "........"
                           "........"
                           "........");
}

void suite_image(void)
{
    RUN(parts_are_their_texels);
    RUN(turns_are_their_quarters);
    RUN(scales_are_exact);
    RUN(scales_of_any_size_are_exact);
    RUN(nine_patches_keep_their_borders);
    RUN(maps_show_the_texel_at_each_centre);
    RUN(quarter_turns_are_turns);
    RUN(inverses_lead_back);
    RUN(maps_that_cannot_be_draw_nothing);
    RUN(an_xor_cursor_takes_itself_away);
}
