/* ports/host/dump.c: PPM and raw files, and the rows that PNG shares. etch-sim calls it. */
#include "dump.h"

#include <stdlib.h>

#include "../../core/base/rgb565.h"

static uint16_t word_at(const struct etch_plane16 *plane, int32_t x, int32_t y)
{
    const uint16_t word = plane->data[(size_t)y * (size_t)plane->stride + (size_t)x];
    return plane->swapped ? etch_rgb565_swap(word) : word;
}

void etch_dump_row(const struct etch_plane16 *plane, int32_t y, uint8_t *rgb)
{
    for (int32_t x = 0; x < plane->width; x++) {
        const uint16_t color = word_at(plane, x, y);

        *rgb++ = etch_rgb565_red(color);
        *rgb++ = etch_rgb565_green(color);
        *rgb++ = etch_rgb565_blue(color);
    }
}

static void raw_row(const struct etch_plane16 *plane, int32_t y, uint8_t *bytes)
{
    for (int32_t x = 0; x < plane->width; x++) {
        const uint16_t word = word_at(plane, x, y);

        *bytes++ = (uint8_t)(word & 0xFF);
        *bytes++ = (uint8_t)(word >> 8);
    }
}

static void byte_row(const struct etch_plane16 *plane, int32_t y, uint8_t *bytes)
{
    for (int32_t x = 0; x < plane->width; x++) {
        *bytes++ = (uint8_t)(word_at(plane, x, y) & 0xFF);
    }
}

static bool write_rows(FILE *file, const struct etch_plane16 *plane, size_t row_size,
                       void (*row)(const struct etch_plane16 *, int32_t, uint8_t *))
{
    uint8_t *bytes = malloc(row_size);
    bool ok = bytes != NULL;

    for (int32_t y = 0; ok && y < plane->height; y++) {
        row(plane, y, bytes);
        ok = fwrite(bytes, 1, row_size, file) == row_size;
    }
    free(bytes);
    return ok;
}

bool etch_dump_ppm(FILE *file, const struct etch_plane16 *plane)
{
    if (fprintf(file, "P6\n%d %d\n255\n", (int)plane->width, (int)plane->height) < 0) {
        return false;
    }
    return write_rows(file, plane, (size_t)plane->width * 3, etch_dump_row);
}

bool etch_dump_raw(FILE *file, const struct etch_plane16 *plane)
{
    return write_rows(file, plane, (size_t)plane->width * 2, raw_row);
}

bool etch_dump_bytes(FILE *file, const struct etch_plane16 *plane)
{
    return write_rows(file, plane, (size_t)plane->width, byte_row);
}
