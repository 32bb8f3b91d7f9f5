/* tests/unit: compressed images: what was packed is drawn, strips and clips change nothing, and
 * hostile data draws what its definition says. */
#include "core/draw/image_rle.h"

#include "tests/harness/canvas.h"

void suite_image_rle(void);

enum {
    ROOM = 6000,
    SIDE = 40
};

static struct test_canvas canvas, whole;
static uint16_t texels[SIDE * SIDE], palette[256], line[2 * SIDE];
static uint8_t alpha[SIDE * SIDE], packed[2][ROOM];
static uint32_t rows[2][SIDE];
static struct etch_rle_image rle;
static struct etch_image plain;
static struct etch_rle_style style;

static const struct kind {
    etch_image_row *row;
    uint8_t bits;
    bool alpha;
} kinds[] = {{etch_row_rgb565, 16, false},    {etch_row_index8, 8, false},
             {etch_row_index4_key, 4, false}, {etch_row_index2, 2, false},
             {etch_row_index1_key, 1, false}, {etch_row_rgb565_alpha, 16, true},
             {etch_row_mask8, 0, true}};
enum {
    KINDS = sizeof kinds / sizeof kinds[0]
};

/* ---- packing, by chance ------------------------------------------------------------------- */

/* Appends the units of one row in packets: mostly as long as they may be, sometimes shorter. */
static uint32_t pack_row(uint8_t *out, const uint8_t *unit, int32_t units, int32_t size,
                         uint32_t *seed)
{
    uint32_t at = 0;

    for (int32_t i = 0; i < units;) {
        int32_t same = 1, n;

        while (i + same < units && same < 129 && unit[(i + same) * size] == unit[i * size] &&
               unit[(i + same) * size + size - 1] == unit[i * size + size - 1])
            same++;
        n = same > 1 ? same : test_range(seed, 1, units - i < 128 ? units - i : 128);
        out[at++] = (uint8_t)(same > 1 ? n + 126 : n - 1);
        for (int32_t k = 0; k < (same > 1 ? size : n * size); k++)
            out[at++] = unit[i * size + k];
        i += n;
    }
    return at;
}

/* Packs the rows of `bytes`, `pitch` bytes each, into plane p. */
static void pack(struct etch_rle_plane *plane, int32_t p, const uint8_t *bytes, int32_t pitch,
                 int32_t size, uint8_t per_unit, uint32_t *seed)
{
    const uint8_t shift = (uint8_t)test_range(seed, 0, 6);
    uint8_t *out = packed[p];
    uint32_t at = 0;

    for (int32_t y = 0; y < plain.height; y++) {
        if (y % (1 << shift) == 0)
            rows[p][y >> shift] = at;
        at += pack_row(out + at, bytes + y * pitch, pitch / size, size, seed);
    }
    for (int32_t i = (int32_t)at - 1; i >= 0;
         i--) /* to the end, so that the sanitizer sees what is read beyond */
        out[ROOM - (int32_t)at + i] = out[i];
    *plane = (struct etch_rle_plane){size == 2 ? etch_rle_words : etch_rle_bytes,
                                     out + ROOM - at,
                                     rows[p],
                                     at,
                                     (uint16_t)(pitch / size),
                                     (uint8_t)size,
                                     per_unit,
                                     shift};
}

/* Texels as they lie in memory, low byte first whatever the machine's order. */
static void pack_texels(const struct kind *k, uint32_t *seed)
{
    static uint8_t bytes[2 * SIDE * SIDE];
    const int32_t pitch = (plain.width * k->bits + 7) / 8;

    for (int32_t i = 0; i < pitch * plain.height; i++)
        bytes[i] = k->bits == 16 ? (uint8_t)(texels[i / 2] >> i % 2 * 8)
                                 : ((const uint8_t *)texels)[i];
    pack(&rle.texels, 0, bytes, pitch, k->bits == 16 ? 2 : 1,
         (uint8_t)(k->bits >= 8 ? 1 : 8 / k->bits), seed);
}

static void make(int32_t i, uint32_t *seed)
{
    const struct kind *k = &kinds[i % KINDS];
    const int32_t per_byte = k->bits == 0 || k->bits >= 8 ? 1 : 8 / k->bits;
    const int32_t lively = test_range(seed, 1, 8);

    for (int32_t j = 0; j < SIDE * SIDE; j++) {
        const bool same = j != 0 && test_range(seed, 0, 8) >= lively;

        texels[j] = same ? texels[j - 1] : (uint16_t)test_random(seed);
        alpha[j] = same ? alpha[j - 1] : (uint8_t)test_random(seed);
    }
    for (int32_t j = 0; j < 256; j++)
        palette[j] = (uint16_t)test_random(seed);
    plain = (struct etch_image){.texels = texels,
                                .alpha = alpha,
                                .palette = palette,
                                .width = (uint16_t)test_range(seed, 1, SIDE - 8),
                                .height = (uint16_t)test_range(seed, 1, SIDE - 8)};
    plain.stride = (uint16_t)((plain.width + per_byte - 1) / per_byte * per_byte);
    rle = (struct etch_rle_image){.image = plain};
    rle.image.texels = NULL, rle.image.alpha = NULL;
    if (k->bits != 0)
        pack_texels(k, seed);
    if (k->alpha)
        pack(&rle.alpha, 1, alpha, plain.stride, 1, 1, seed);
    style = (struct etch_rle_style){&rle, k->row, 200, line};
    for (int32_t j = 0; j < 2 * SIDE; j++)
        line[j] = 0xBEEF;
}

static void compare(const struct test_canvas *a, const struct test_canvas *b)
{
    const struct etch_rect w = a->surface.window;
    int32_t wrong = 0;

    for (int32_t y = w.y0; y < w.y1; y++)
        for (int32_t x = w.x0; x < w.x1; x++)
            wrong += test_canvas_at(a, x, y) != test_canvas_at(b, x, y);
    CHECK_EQ(wrong, 0);
}

/* ---- tests -------------------------------------------------------------------------------- */

static const struct etch_rect window = {10, 20, 60, 60};

static void what_was_packed_is_drawn(void)
{
    uint32_t seed = 1;

    for (int32_t i = 0; i < TEST_COUNT(2100) && !test_failed(); i++) {
        const int16_t x = (int16_t)test_range(&seed, -20, 65),
                      y = (int16_t)test_range(&seed, -10, 65);
        const struct etch_rect clip = {
            (int16_t)test_range(&seed, 0, 50), (int16_t)test_range(&seed, 0, 50),
            (int16_t)test_range(&seed, 30, 70), (int16_t)test_range(&seed, 30, 70)};

        make(i, &seed);
        const struct etch_image_style uncompressed = {&plain, style.row, style.opacity};
        const uint32_t used = (etch_rle_line_size(&rle) + 1) / 2;

        test_canvas_open(&canvas, window);
        test_canvas_open(&whole, window);
        etch_image_draw(&whole.surface, &uncompressed, x, y);
        etch_rle_draw(&canvas.surface, &style, x, y);
        compare(&canvas, &whole);
        CHECK_INSIDE(&canvas);
        CHECK_EQ(line[used], 0xBEEF);

        test_canvas_clip(&whole, clip);
        etch_image_draw(&whole.surface, &uncompressed, x, y);
        test_canvas_clip(&canvas, clip);
        etch_rle_draw(&canvas.surface, &style, x, y);
        compare(&canvas, &whole);
        if (!CHECK_ONCE(&canvas))
            test_note("i", i);
    }
}

/* ---- hostile data ------------------------------------------------------------------------- */

/* The units of row y by the definition of image_rle.h; returns how many. */
static int32_t define_row(const struct etch_rle_plane *p, int32_t y, uint8_t *out)
{
    const int32_t group = 1 << p->rows_shift, size = p->unit_size;
    int64_t at = p->rows[y / group];
    int32_t n = 0;

    if (at > p->size)
        at = p->size;
    for (int32_t row = y / group * group; row <= y; row++) {
        n = 0;
        while (n < p->units && at < p->size) {
            const int32_t c = p->data[at++], times = c < 128 ? 1 : c - 126;
            int32_t units = c < 128 ? c + 1 : 1;
            const bool cut = at + units * size > p->size;

            units = cut ? (int32_t)(p->size - at) / size : units;
            for (int32_t u = 0; u < units; u++)
                for (int32_t t = 0; t < times && n < p->units; t++, n++)
                    for (int32_t b = 0; b < size; b++)
                        out[n * size + b] = p->data[at + u * size + b];
            at = cut ? p->size : at + units * size;
            if (cut)
                break;
        }
    }
    return n;
}

static void spoil(struct etch_rle_plane *plane, uint8_t *bytes, uint32_t *table, uint32_t *seed)
{
    uint8_t *const data = bytes + ROOM - plane->size;
    const int32_t last = (plain.height - 1) >> plane->rows_shift;

    for (int32_t k = test_range(seed, 0, 6); k > 0 && plane->size > 0; k--)
        data[test_range(seed, 0, (int32_t)plane->size - 1)] = (uint8_t)test_random(seed);
    if (test_range(seed, 0, 3) == 0)
        table[test_range(seed, 0, last)] = test_range(seed, 0, 1) == 0
                                               ? test_random(seed)
                                               : (uint32_t)test_range(seed, 0,
                                                                      (int32_t)plane->size);
    if (test_range(seed, 0, 2) == 0) { /* truncated: moved, so that it still ends with the array */
        const uint32_t size = (uint32_t)test_range(seed, 0, (int32_t)plane->size);

        for (int32_t i = (int32_t)size - 1; i >= 0; i--)
            bytes[ROOM - (int32_t)size + i] = data[i];
        plane->data = bytes + ROOM - size;
        plane->size = size;
    }
}

/* The uncompressed image that the spoilt one stands for; returns the texels of row y. */
static int32_t unpack(const struct kind *k, int32_t y)
{
    static uint8_t bytes[2 * SIDE];
    int32_t n = plain.width;

    if (k->bits != 0) {
        const int32_t units = define_row(&rle.texels, y, bytes), got = units * rle.texels.per_unit;

        n = got < n ? got : n;
        for (int32_t i = 0; i < units; i++) {
            if (k->bits == 16)
                texels[y * plain.stride + i] = (uint16_t)(bytes[2 * i] | bytes[2 * i + 1] << 8);
            else
                ((uint8_t *)texels)[y * (plain.stride * k->bits / 8) + i] = bytes[i];
        }
    }
    if (k->alpha) {
        const int32_t got = define_row(&rle.alpha, y, alpha + y * plain.stride);

        n = got < n ? got : n;
    }
    return n;
}

static void hostile_data_draws_what_it_says(void)
{
    uint32_t seed = 2;
    int64_t lost = 0;

    for (int32_t i = 0; i < TEST_COUNT(4200) && !test_failed(); i++) {
        const struct kind *k = &kinds[i % KINDS];
        const int16_t x = (int16_t)test_range(&seed, 0, 40), y = (int16_t)test_range(&seed, 10, 50);
        const struct etch_rect strip = {0, (int16_t)test_range(&seed, 20, 50), 100, 100};

        make(i, &seed);
        if (k->bits != 0)
            spoil(&rle.texels, packed[0], rows[0], &seed);
        if (k->alpha)
            spoil(&rle.alpha, packed[1], rows[1], &seed);
        const struct etch_image_style uncompressed = {&plain, style.row, style.opacity};

        test_canvas_open(&whole, window);
        for (int32_t v = 0; v < plain.height; v++) {
            const struct etch_rect part = {0, (int16_t)v, (int16_t)unpack(k, v), (int16_t)(v + 1)};

            lost += plain.width - part.x1;
            etch_image_draw_part(&whole.surface, &uncompressed, part, x, (int16_t)(y + v));
        }
        test_canvas_open(&canvas, window);
        etch_rle_draw(&canvas.surface, &style, x, y);
        compare(&canvas, &whole);
        CHECK_ONCE(&canvas);

        test_canvas_open(&canvas, window); /* two strips, the lower one first */
        etch_surface_clip(&canvas.surface, strip);
        etch_rle_draw(&canvas.surface, &style, x, y);
        etch_surface_clip(&canvas.surface, (struct etch_rect){0, 0, 100, strip.y0});
        etch_rle_draw(&canvas.surface, &style, x, y);
        etch_surface_clip(&canvas.surface, window);
        compare(&canvas, &whole);
        CHECK_INSIDE(&canvas);
        if (test_failed())
            test_note("i", i);
    }
    CHECK(test_failed() || lost > TEST_COUNT(4200) * 10);
}

/* 3 literals, 2 + 129 of the same, cut at the row's end; the next row begins behind the packet. */
static void packets_are_what_the_header_says(void)
{
    static const uint8_t data[] = {2, 1, 2, 3, 128, 4, 255, 5, 1, 6, 7, 129, 1};
    static const uint32_t offsets[] = {0};
    static const uint16_t colors[] = {0, 1, 2, 3, 4, 5, 6, 7};
    const struct etch_rle_image image = {
        .image = {.palette = colors, .width = 8, .height = 3, .stride = 8},
        .texels = {etch_rle_bytes, data, offsets, sizeof data, 8, 1, 1, 2}};
    const struct etch_rle_style s = {&image, etch_row_index8, 255, line};
    const struct etch_rect w = {0, 0, 9, 3};

    test_canvas_open(&canvas, w);
    etch_rle_draw(&canvas.surface, &s, 0, 0);
    CHECK_PICTURE(&canvas, "abcddeee."
                           "fgaaa...."
                           ".........");
}

void suite_image_rle(void)
{
    RUN(packets_are_what_the_header_says);
    RUN(what_was_packed_is_drawn);
    RUN(hostile_data_draws_what_it_says);
}
