/* tests/cli: picture files against the pixels they came from. The PNG reader below is for these
 * tests alone. */
#include "ports/host/dump.h"

#include <stdlib.h>
#include <string.h>

#include "core/base/rgb565.h"
#include "ports/host/deflate.h"
#include "tests/harness/harness.h"

void suite_dump(void);

enum {
    MAX = 300 * 200
};
static uint16_t pixels[MAX];

/* 0 noise, 1 gradient, 2 stripes, 3 one colour. */
static void fill(int kind, int32_t width, int32_t height, uint32_t *state)
{
    for (int32_t i = 0; i < width * height; i++) {
        const int32_t x = i % width, y = i / width;

        pixels[i] = kind == 0   ? (uint16_t)(test_random(state) & 0xFFFF)
                    : kind == 1 ? (uint16_t)((x * 31 / width) << 11 | (y * 63 / height) << 5)
                    : kind == 2 ? (uint16_t)(x % 7 * 9000 + y % 3)
                                : 0x1234;
    }
}

/* The files of one picture, in memory. */
static size_t dump_to(etch_dump *dump, const struct etch_plane16 *plane, uint8_t *bytes,
                      size_t room)
{
    FILE *file = tmpfile();
    size_t size = 0;

    if (CHECK(file != NULL && dump(file, plane))) {
        rewind(file);
        size = fread(bytes, 1, room, file);
    }
    if (file != NULL)
        (void)fclose(file);
    return size;
}

static const int32_t sizes[][2] = {{1, 1}, {2, 1}, {1, 200}, {300, 1}, {17, 5}, {300, 200}};

/* Swapped or not, with a stride or not: the same bytes, and those of the definition. */
static void words_and_rows(void)
{
    static uint8_t raw[MAX * 2], ppm[MAX * 3 + 20];
    const struct etch_plane16 plane = {pixels, 2, 2, 3, false};
    const struct etch_plane16 swapped = {pixels, 2, 2, 3, true};
    static const uint8_t plain_raw[] = {0x34, 0x12, 0x00, 0xF8, 0x1F, 0x00, 0xE0, 0x07};
    static const uint8_t swapped_raw[] = {0x12, 0x34, 0xF8, 0x00, 0x00, 0x1F, 0x07, 0xE0};
    static const char plain_ppm[] = "P6\n2 2\n255\n\x10\x45\xA5\xFF\0\0\0\0\xFF\0\xFF\0";
    const uint16_t stored[] = {0x1234, 0xF800, 0xDEAD, 0x001F, 0x07E0, 0xDEAD};

    memcpy(pixels, stored, sizeof stored);
    CHECK_EQ(dump_to(etch_dump_raw, &plane, raw, sizeof raw), 8);
    CHECK(memcmp(raw, plain_raw, 8) == 0);
    CHECK_EQ(dump_to(etch_dump_raw, &swapped, raw, sizeof raw), 8);
    CHECK(memcmp(raw, swapped_raw, 8) == 0);
    CHECK_EQ(dump_to(etch_dump_ppm, &plane, ppm, sizeof ppm), sizeof plain_ppm - 1);
    CHECK(memcmp(ppm, plain_ppm, sizeof plain_ppm - 1) == 0);
}

/* ---- PNG: chunks and their sums, the zlib stream, the rows ------------------------------------
 */

static uint32_t load_u32(const uint8_t *p)
{
    return (uint32_t)p[0] << 24 | (uint32_t)p[1] << 16 | (uint32_t)p[2] << 8 | p[3];
}

/* The CRC of the specification, a bit a step. */
static uint32_t crc(const uint8_t *p, size_t size)
{
    uint32_t c = UINT32_C(0xFFFFFFFF);

    for (size_t i = 0; i < size * 8; i++) {
        const uint32_t bit = (c ^ (uint32_t)p[i / 8] >> i % 8) & 1;
        c = c >> 1 ^ (bit ? UINT32_C(0xEDB88320) : 0);
    }
    return c ^ UINT32_C(0xFFFFFFFF);
}

/* A reader of what deflate.c writes: one block of fixed codes (RFC 1951, 3.2.6). */
struct bits {
    const uint8_t *p, *end;
    uint32_t n;
    bool over;
};

static uint32_t take(struct bits *b, int n)
{
    uint32_t value = 0;

    for (int i = 0; i < n; i++) {
        if (b->p == b->end) {
            b->over = true;
            return 0;
        }
        value |= (uint32_t)(*b->p >> b->n & 1) << i;
        b->p += ++b->n == 8;
        b->n %= 8;
    }
    return value;
}

static uint32_t take_code(struct bits *b, int n, uint32_t code)
{
    for (int i = 0; i < n; i++)
        code = code << 1 | take(b, 1);
    return code;
}

static uint32_t take_symbol(struct bits *b)
{
    uint32_t code = take_code(b, 7, 0);

    if (code < 0x18)
        return 256 + code;
    code = take_code(b, 1, code);
    if (code < 0xC0)
        return code - 0x30;
    if (code < 0xC8)
        return 280 + code - 0xC0;
    return 144 + take_code(b, 1, code) - 0x190;
}

static const uint16_t length_base[] = {3,  4,  5,  6,   7,   8,   9,   10,  11, 13,
                                       15, 17, 19, 23,  27,  31,  35,  43,  51, 59,
                                       67, 83, 99, 115, 131, 163, 195, 227, 258};
static const uint8_t length_extra[] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2,
                                       2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0};
static const uint16_t distance_base[] = {
    1,   2,   3,   4,   5,   7,    9,    13,   17,   25,   33,   49,   65,    97,    129,
    193, 257, 385, 513, 769, 1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577};

/* Returns the size of the text, 0 if the stream is wrong. */
static size_t inflate(const uint8_t *from, size_t size, uint8_t *text, size_t room)
{
    struct bits b = {from + 2, from + size, 0, false};
    uint32_t sum_a = 1, sum_b = 0, symbol;
    size_t n = 0;

    if (take(&b, 3) != 3)
        return 0;
    while ((symbol = take_symbol(&b)) != 256 && !b.over) {
        if (symbol < 256 && n < room) {
            text[n++] = (uint8_t)symbol;
        } else {
            const uint32_t l = symbol - 257;
            const uint32_t length = length_base[l] + take(&b, length_extra[l]);
            const uint32_t d = take_code(&b, 5, 0);
            const uint32_t distance = distance_base[d] + take(&b, d < 2 ? 0 : (int)d / 2 - 1);

            if (distance > n || n + length > room)
                return 0;
            for (uint32_t i = 0; i < length; i++, n++)
                text[n] = text[n - distance];
        }
    }
    for (size_t i = 0; i < n; i++) {
        sum_a = (sum_a + text[i]) % 65521;
        sum_b = (sum_b + sum_a) % 65521;
    }
    b.p += b.n != 0;
    return !b.over && b.end - b.p == 4 && load_u32(b.p) == (sum_b << 16 | sum_a) ? n : 0;
}

static void check_png(const struct etch_plane16 *plane, const uint8_t *png, size_t size)
{
    static uint8_t packed[MAX * 4], text[MAX * 3 + 300];
    size_t at = 8, n_packed = 0, n = 0;

    CHECK(size > 8 && memcmp(png, "\x89PNG\r\n\x1A\n", 8) == 0);
    while (at + 12 <= size) {
        const uint32_t length = load_u32(png + at);

        if (!CHECK(length <= size - at - 12) ||
            !CHECK_EQ(load_u32(png + at + 8 + length), crc(png + at + 4, length + 4)))
            return;
        if (memcmp(png + at + 4, "IDAT", 4) == 0) {
            memcpy(packed + n_packed, png + at + 8, length);
            n_packed += length;
        }
        at += length + 12;
    }
    CHECK_EQ(at, size);
    CHECK(load_u32(png + 16) == (uint32_t)plane->width &&
          load_u32(png + 20) == (uint32_t)plane->height);
    n = inflate(packed, n_packed, text, sizeof text);
    CHECK_EQ(n, (plane->width * 3 + 1) * plane->height);
    for (int32_t y = 0; y < plane->height && !test_failed(); y++) {
        uint8_t *row = text + (size_t)y * ((size_t)plane->width * 3 + 1);

        CHECK_EQ(row[0], 2);
        for (int32_t i = 1; i <= plane->width * 3; i++) {
            const uint16_t c = pixels[y * plane->width + (i - 1) / 3];
            const uint8_t channel[3] = {etch_rgb565_red(c), etch_rgb565_green(c),
                                        etch_rgb565_blue(c)};

            if (y > 0)
                row[i] = (uint8_t)((row[i] + row[i - plane->width * 3 - 1]) & 0xFF);
            CHECK_EQ(row[i], channel[(i - 1) % 3]);
        }
    }
}

static void png_holds_the_pixels(void)
{
    static uint8_t png[MAX * 4];
    uint32_t state = 3;

    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        for (int kind = 0; kind < 4; kind++) {
            const struct etch_plane16 plane = {pixels, sizes[i][0], sizes[i][1], sizes[i][0],
                                               false};

            fill(kind, sizes[i][0], sizes[i][1], &state);
            check_png(&plane, png, dump_to(etch_dump_png, &plane, png, sizeof png));
        }
    }
}

/* 180,000 bytes of one colour pack a hundredfold. */
static void flat_pictures_are_small(void)
{
    static uint8_t png[MAX * 4];
    const struct etch_plane16 plane = {pixels, 300, 200, 300, false};
    uint32_t state = 1;

    fill(3, 300, 200, &state);
    CHECK(dump_to(etch_dump_png, &plane, png, sizeof png) < 1800);
}

void suite_dump(void)
{
    RUN(words_and_rows);
    RUN(png_holds_the_pixels);
    RUN(flat_pictures_are_small);
}
