/* tests/tools: pixels to a PNG file of stored blocks. Called by picture_diff.c. See png_write.h. */
#include "png_write.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

uint32_t png_crc32(const uint8_t *p, size_t n)
{
    uint32_t crc = UINT32_MAX;
    int k;

    for (; n != 0; n--) {
        crc ^= *p++;
        for (k = 0; k < 8; k++)
            crc = (crc >> 1) ^ ((crc & 1) != 0 ? UINT32_C(0xEDB88320) : 0);
    }
    return crc ^ UINT32_MAX;
}

static uint8_t *put_word(uint8_t *to, uint32_t v)
{
    *to++ = (uint8_t)(v >> 24);
    *to++ = (uint8_t)(v >> 16 & 255);
    *to++ = (uint8_t)(v >> 8 & 255);
    *to++ = (uint8_t)(v & 255);
    return to;
}

/* Writes a chunk; `data` has 8 bytes of room before it and 4 behind. */
static bool put_chunk(FILE *f, const char *type, uint8_t *data, size_t n)
{
    put_word(data - 8, (uint32_t)n);
    memcpy(data - 4, type, 4);
    put_word(data + n, png_crc32(data - 4, n + 4));
    return fwrite(data - 8, 1, n + 12, f) == n + 12;
}

/* A zlib stream of one stored block a row; returns its end. */
static uint8_t *store_rows(uint8_t *to, const struct picture *p)
{
    const size_t n = (size_t)p->width * 3;
    uint32_t a = 1, b = 0;
    size_t i, y;

    *to++ = 0x78;
    *to++ = 0x01;
    for (y = 0; y < p->height; y++) {
        const uint32_t length = (uint32_t)n + 1;

        *to++ = y + 1 == p->height;
        *to++ = (uint8_t)(length & 255);
        *to++ = (uint8_t)(length >> 8);
        *to++ = (uint8_t)(~length & 255);
        *to++ = (uint8_t)(~length >> 8 & 255);
        *to++ = 0; /* no filter */
        memcpy(to, p->rgb + y * n, n);
        b = (b + a) % 65521; /* of the filter byte */
        for (i = 0; i < n; i++) {
            a = (a + to[i]) % 65521;
            b = (b + a) % 65521;
        }
        to += n;
    }
    return put_word(to, b << 16 | a);
}

bool png_write(const struct picture *p, const char *path)
{
    uint8_t header[8 + 13 + 4] = {0}, end[8 + 4];
    uint8_t *data;
    bool ok;
    FILE *f;

    if (p->width * 3 + 1 > 65535) /* a row is one stored block */
        return false;
    data = malloc(((size_t)p->width * 3 + 6) * p->height + 32);
    f = data != NULL ? fopen(path, "wb") : NULL;
    if (f == NULL) {
        free(data);
        return false;
    }
    put_word(put_word(header + 8, p->width), p->height);
    header[8 + 8] = 8;
    header[8 + 9] = 2;
    ok = fwrite("\x89PNG\r\n\x1a\n", 1, 8, f) == 8 && put_chunk(f, "IHDR", header + 8, 13) &&
         put_chunk(f, "IDAT", data + 8, (size_t)(store_rows(data + 8, p) - (data + 8))) &&
         put_chunk(f, "IEND", end + 8, 0);
    free(data);
    return fclose(f) == 0 && ok;
}
