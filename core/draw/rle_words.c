/* draw/rle_words.c: rows of compressed 16-bit units. Called once a row through the image's plane.
 * See image_rle.h. */
#include "rle_decode.h"

ETCH_INLINE uint16_t word(const uint8_t *p)
{
    return (uint16_t)(p[0] | (uint32_t)p[1] << 8);
}

ETCH_INLINE void copy(void *out, uint16_t at, const uint8_t *from, uint16_t n)
{
    uint16_t *to = (uint16_t *)out + at;

    for (; n != 0; n--, from += 2)
        *to++ = word(from);
}

ETCH_INLINE void fill(void *out, uint16_t at, const uint8_t *unit, uint16_t n)
{
    uint16_t *to = (uint16_t *)out + at;

    if (n == 0)
        return; /* perhaps there is no unit */
    for (const uint16_t value = word(unit); n != 0; n--)
        *to++ = value;
}

uint16_t etch_rle_words(struct etch_rle_cursor *cursor, void *out, uint16_t keep, uint16_t units)
{
    return etch_rle_row(cursor, out, keep, units, 2, copy, fill);
}
