/* draw/rle_bytes.c: rows of compressed bytes. Called once a row through the image's plane. See
 * image_rle.h. */
#include "rle_decode.h"

ETCH_INLINE void copy(void *out, uint16_t at, const uint8_t *from, uint16_t n)
{
    uint8_t *to = (uint8_t *)out + at;

    for (; n != 0; n--)
        *to++ = *from++;
}

ETCH_INLINE void fill(void *out, uint16_t at, const uint8_t *unit, uint16_t n)
{
    uint8_t *to = (uint8_t *)out + at;

    for (; n != 0; n--)
        *to++ = *unit;
}

uint16_t etch_rle_bytes(struct etch_rle_cursor *cursor, void *out, uint16_t keep, uint16_t units)
{
    return etch_rle_row(cursor, out, keep, units, 1, copy, fill);
}
