/* tests/tools: PNG files to pixels. Called by picture_diff.c. See png_read.h. */
#include "png_read.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "png_write.h"

static uint32_t word(const uint8_t *p)
{
    return (uint32_t)p[0] << 24 | (uint32_t)p[1] << 16 | (uint32_t)p[2] << 8 | p[3];
}

static uint8_t *load(const char *path, size_t *n)
{
    FILE *f = fopen(path, "rb");
    uint8_t *p = NULL;
    long size = -1;

    if (f == NULL)
        return NULL;
    if (fseek(f, 0, SEEK_END) == 0 && (size = ftell(f)) > 0 && fseek(f, 0, SEEK_SET) == 0)
        p = malloc((size_t)size);
    if (p != NULL && fread(p, 1, (size_t)size, f) != (size_t)size) {
        free(p);
        p = NULL;
    }
    fclose(f);
    *n = (size_t)size;
    return p;
}

/* The header and the joined data of the chunks, in place. */
static const char *read_chunks(struct picture *p, uint8_t *file, size_t n, size_t *packed)
{
    static const uint8_t header[13] = {0, 0, 0, 0, 0, 0, 0, 0, 8, 2, 0, 0, 0};
    size_t at = 8;

    *packed = 0;
    if (n < 8 || memcmp(file, "\x89PNG\r\n\x1a\n", 8) != 0)
        return "no PNG file";
    while (at + 12 <= n) {
        const uint32_t length = word(file + at);
        const uint8_t *type = file + at + 4, *data = type + 4;

        if (length > n - at - 12 || png_crc32(type, length + 4) != word(data + length))
            return "a broken chunk";
        if (memcmp(type, "IHDR", 4) == 0) {
            if (length != 13 || memcmp(data + 8, header + 8, 5) != 0)
                return "not 8-bit RGB";
            p->width = word(data);
            p->height = word(data + 4);
        } else if (memcmp(type, "IDAT", 4) == 0) {
            memmove(file + *packed, data, length);
            *packed += length;
        } else if (memcmp(type, "IEND", 4) == 0) {
            return p->width >= 1 && p->width <= 32767 && p->height >= 1 && p->height <= 32767
                       ? NULL
                       : "an impossible size";
        }
        at += 12 + (size_t)length;
    }
    return "no end";
}

static uint8_t nearest_of(int32_t left, int32_t up, int32_t corner)
{
    const int32_t a = abs(up - corner), b = abs(left - corner), c = abs(left + up - 2 * corner);

    return (uint8_t)(a <= b && a <= c ? left : b <= c ? up : corner);
}

/* Undoes the filter of a row of n bytes; `above` is the finished row above or NULL. */
static const char *unfilter(uint8_t filter, uint8_t *row, const uint8_t *above, size_t n)
{
    size_t i;

    for (i = 0; i < n; i++) {
        const uint8_t left = i >= 3 ? row[i - 3] : 0, up = above != NULL ? above[i] : 0;
        const uint8_t corner = i >= 3 && above != NULL ? above[i - 3] : 0;
        int32_t guess = 0;

        switch (filter) {
        case 0: break;
        case 1: guess = left; break;
        case 2: guess = up; break;
        case 3: guess = (left + up) / 2; break;
        case 4: guess = nearest_of(left, up, corner); break;
        default: return "an unknown filter";
        }
        row[i] = (uint8_t)((row[i] + guess) & 255);
    }
    return NULL;
}

/* Filtered rows to pixels, in place. */
static const char *unpack_rows(const struct picture *p, uint8_t *rows)
{
    const size_t n = (size_t)p->width * 3;
    const char *wrong = NULL;
    size_t y;

    for (y = 0; y < p->height && wrong == NULL; y++) {
        uint8_t *row = p->rgb + y * n;

        memcpy(row, rows + y * (n + 1) + 1, n);
        wrong = unfilter(rows[y * (n + 1)], row, y > 0 ? row - n : NULL, n);
    }
    return wrong;
}

const char *png_read(struct picture *p, const char *path)
{
    const char *wrong;
    uint8_t *rows = NULL, *file;
    size_t n, packed, size;

    p->width = 0;
    p->height = 0;
    p->rgb = NULL;
    file = load(path, &n);
    if (file == NULL)
        return "cannot be read";
    wrong = read_chunks(p, file, n, &packed);
    if (wrong == NULL) {
        size = ((size_t)p->width * 3 + 1) * p->height;
        rows = malloc(size);
        p->rgb = malloc(size);
        wrong = rows == NULL || p->rgb == NULL ? "too large" : inflate(rows, size, file, packed);
    }
    if (wrong == NULL)
        wrong = unpack_rows(p, rows);
    free(rows);
    free(file);
    return wrong;
}
