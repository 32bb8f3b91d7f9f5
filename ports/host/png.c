/* ports/host/png.c: frames to PNG. etch-sim calls it through dump.h.
 * Format: W3C, Portable Network Graphics Specification, second edition, 2003. */
#include <stdlib.h>
#include <string.h>

#include "deflate.h"
#include "dump.h"

/* Compressed bytes gather here and leave as one IDAT chunk when it is full. */
struct png {
    FILE *file;
    bool failed;
    uint32_t crc_of[256];
    uint32_t used;
    uint8_t chunk[65536];
    struct etch_deflate deflate;
};

static void make_crc_table(struct png *png)
{
    for (uint32_t i = 0; i < 256; i++) {
        uint32_t crc = i;

        for (int bit = 0; bit < 8; bit++) {
            crc = crc >> 1 ^ (crc & 1 ? UINT32_C(0xEDB88320) : 0);
        }
        png->crc_of[i] = crc;
    }
}

static uint32_t crc_add(const struct png *png, uint32_t crc, const uint8_t *bytes, uint32_t size)
{
    for (uint32_t i = 0; i < size; i++) {
        crc = png->crc_of[(crc ^ bytes[i]) & 0xFF] ^ crc >> 8;
    }
    return crc;
}

static void store_u32(uint8_t bytes[4], uint32_t value)
{
    for (int i = 0; i < 4; i++) {
        bytes[i] = (uint8_t)(value >> (24 - 8 * i) & 0xFF);
    }
}

static void put(struct png *png, const void *bytes, uint32_t size)
{
    if (!png->failed && fwrite(bytes, 1, size, png->file) != size) {
        png->failed = true;
    }
}

static void put_chunk(struct png *png, const char type[5], const uint8_t *bytes, uint32_t size)
{
    uint8_t head[8], tail[4];
    uint32_t crc;

    store_u32(head, size);
    memcpy(head + 4, type, 4);
    crc = crc_add(png, UINT32_C(0xFFFFFFFF), head + 4, 4);
    crc = crc_add(png, crc, bytes, size) ^ UINT32_C(0xFFFFFFFF);
    store_u32(tail, crc);
    put(png, head, sizeof head);
    put(png, bytes, size);
    put(png, tail, sizeof tail);
}

static void take_byte(void *context, uint8_t byte)
{
    struct png *png = context;

    png->chunk[png->used++] = byte;
    if (png->used == sizeof png->chunk) {
        put_chunk(png, "IDAT", png->chunk, png->used);
        png->used = 0;
    }
}

/* Sends all rows, each with the filter "up", which makes rows that repeat zero. */
static void put_rows(struct png *png, const struct etch_plane16 *plane, uint8_t *row,
                     uint8_t *above, uint8_t *line)
{
    const size_t size = (size_t)plane->width * 3;

    memset(above, 0, size);
    for (int32_t y = 0; y < plane->height && !png->failed; y++) {
        uint8_t *swap = above;

        etch_dump_row(plane, y, row);
        line[0] = 2;
        for (size_t i = 0; i < size; i++) {
            line[1 + i] = (uint8_t)((256 + row[i] - above[i]) & 0xFF);
        }
        etch_deflate_bytes(&png->deflate, line, size + 1);
        above = row;
        row = swap;
    }
}

static void put_picture(struct png *png, const struct etch_plane16 *plane, uint8_t *rows)
{
    static const uint8_t signature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    const size_t size = (size_t)plane->width * 3;
    uint8_t header[13] = {[8] = 8, [9] = 2}; /* 8 bits a channel, RGB */

    store_u32(header, (uint32_t)plane->width);
    store_u32(header + 4, (uint32_t)plane->height);
    put(png, signature, sizeof signature);
    put_chunk(png, "IHDR", header, sizeof header);
    etch_deflate_begin(&png->deflate, take_byte, png);
    put_rows(png, plane, rows, rows + size, rows + 2 * size);
    etch_deflate_end(&png->deflate);
    put_chunk(png, "IDAT", png->chunk, png->used);
    put_chunk(png, "IEND", NULL, 0);
}

bool etch_dump_png(FILE *file, const struct etch_plane16 *plane)
{
    struct png *png = malloc(sizeof *png);
    uint8_t *rows = malloc((size_t)plane->width * 9 + 1);
    bool ok = png != NULL && rows != NULL;

    if (ok) {
        png->file = file;
        png->failed = false;
        png->used = 0;
        make_crc_table(png);
        put_picture(png, plane, rows);
        ok = !png->failed;
    }
    free(png);
    free(rows);
    return ok;
}
