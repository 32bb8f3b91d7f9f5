/* ports/host/scene_image_rle.c: compresses the images of scenes. scene_image.c calls it. */
#include <string.h>

#include "scene_image.h"
#include "scene_steps.h"

/* Equal units at the front of n. */
static size_t run(const uint8_t *unit, size_t n, size_t size)
{
    size_t same = 1;

    while (same < n && memcmp(unit, unit + same * size, size) == 0) {
        same++;
    }
    return same;
}

static size_t pack_row(uint8_t *out, const uint8_t *unit, size_t units, size_t size)
{
    size_t at = 0, n;

    for (size_t i = 0; i < units; i += n) {
        n = run(unit + i * size, units - i < 129 ? units - i : 129, size);
        if (n >= 3) {
            out[at++] = (uint8_t)(n + 126);
            memcpy(out + at, unit + i * size, size);
            at += size;
            continue;
        }
        for (n = 1;
             n < 128 && i + n < units && run(unit + (i + n) * size, units - i - n, size) < 3;) {
            n++;
        }
        out[at++] = (uint8_t)(n - 1);
        memcpy(out + at, unit + i * size, n * size);
        at += n * size;
    }
    return at;
}

bool etch_scene_compress(struct etch_scene_reader *reader, struct etch_rle_plane *plane,
                         const uint8_t *bytes, size_t pitch, size_t height)
{
    const size_t units = pitch / plane->unit_size;
    uint8_t *const data = etch_scene_data(reader, (pitch * 2 + 2) * height);
    uint32_t *const rows = etch_scene_data(reader, (height / 4 + 1) * sizeof *rows);
    size_t at = 0;

    if (data == NULL || rows == NULL) {
        return false;
    }
    plane->data = data;
    plane->rows = rows;
    plane->rows_shift = 2;
    plane->units = (uint16_t)units;
    for (size_t y = 0; y < height; y++) {
        if (y % 4 == 0) {
            rows[y / 4] = (uint32_t)at;
        }
        at += pack_row(data + at, bytes + y * pitch, units, plane->unit_size);
    }
    plane->size = (uint32_t)at;
    return true;
}
