/* draw/rle_decode.h: the loop of the decoders; no part of the API. */
#ifndef ETCH_DRAW_RLE_DECODE_H
#define ETCH_DRAW_RLE_DECODE_H

#include "image_rle.h"

typedef void etch_rle_copy(void *out, uint16_t at, const uint8_t *from, uint16_t n);
typedef void etch_rle_fill(void *out, uint16_t at, const uint8_t *unit, uint16_t n);

ETCH_INLINE uint16_t etch_rle_least(uint32_t a, uint32_t b)
{
    return (uint16_t)(a < b ? a : b);
}

/* How many of the next n units, the first of them number `at`, are kept. */
ETCH_INLINE uint16_t etch_rle_kept(uint16_t at, uint16_t n, uint16_t keep)
{
    return at < keep ? etch_rle_least(n, (uint32_t)keep - at) : 0;
}

ETCH_INLINE uint16_t etch_rle_row(struct etch_rle_cursor *cursor, void *out, uint16_t keep,
                                  uint16_t units, uint8_t size, etch_rle_copy *copy,
                                  etch_rle_fill *fill)
{
    const uint8_t *p = cursor->at;
    const uint8_t *const end = cursor->end;
    uint16_t at = 0;

    while (at < units && p != end) {
        const uint8_t control = *p++;
        const bool same = control >= 128;
        const uint32_t there = (uint32_t)(end - p) / size;
        uint16_t n = etch_rle_least(same ? control - 126U : control + 1U, (uint32_t)units - at);
        const uint32_t read = same ? 1 : control + 1U;

        if (read > there) { /* the data ends in this packet */
            n = same ? 0 : etch_rle_least(n, there);
            units = (uint16_t)(at + n);
        }
        (same ? fill : copy)(out, at, p, etch_rle_kept(at, n, keep));
        p = read > there ? end : p + (size_t)read * size;
        at = (uint16_t)(at + n);
    }
    cursor->at = p;
    return at < keep ? at : keep;
}

#endif
