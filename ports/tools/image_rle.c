/* ports/tools/image_rle.c: packs planes by runs. Called by etch-image. See image_format.h. */
#include <stdlib.h>
#include <string.h>

#include "image_format.h"

/* Equal units from `unit` on, up to n. */
static int run(const uint8_t *unit, int n, int size)
{
    int same = 1;

    while (same < n && memcmp(unit, unit + same * size, (size_t)size) == 0)
        same++;
    return same;
}

/* A run is worth a packet from `worth` units on. */
static size_t pack_row(uint8_t *out, const uint8_t *unit, int units, int size)
{
    const int worth = size == 1 ? 3 : 2;
    size_t at = 0;

    for (int i = 0; i < units;) {
        int n = run(unit + i * size, units - i < 129 ? units - i : 129, size);

        if (n >= worth) {
            out[at++] = (uint8_t)(n + 126);
            memcpy(out + at, unit + i * size, (size_t)size);
            at += (size_t)size;
        } else {
            n = 0;
            while (n < 128 && i + n < units &&
                   run(unit + (i + n) * size, units - i - n, size) < worth)
                n++;
            out[at++] = (uint8_t)(n - 1);
            memcpy(out + at, unit + i * size, (size_t)(n * size));
            at += (size_t)(n * size);
        }
        i += n;
    }
    return at;
}

void image_compress(struct plane *plane, int height, int rows_shift)
{
    uint8_t *const out = image_memory(((size_t)plane->pitch * 2 + 2) * (size_t)height);
    size_t at = 0;

    if (plane->size == 0) {
        free(out);
        return;
    }
    plane->rows = image_memory(((size_t)((height - 1) >> rows_shift) + 1) * sizeof *plane->rows);
    for (int y = 0; y < height; y++) {
        if (y % (1 << rows_shift) == 0)
            plane->rows[y >> rows_shift] = (uint32_t)at;
        at += pack_row(out + at, plane->bytes + (size_t)y * (size_t)plane->pitch,
                       plane->pitch / plane->unit_size, plane->unit_size);
    }
    free(plane->bytes);
    plane->bytes = out;
    plane->size = at;
}
