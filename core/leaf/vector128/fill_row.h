/* leaf/vector128/fill_row.h: a row of one value, for fill.c and flat.c. */
#ifndef ETCH_LEAF_FILL_ROW_H
#define ETCH_LEAF_FILL_ROW_H

#include "vector.h"

/* n >= 8 elements: eight at a time, the last eight by themselves, which may overlap. */
ETCH_INLINE void fill_long(uint16_t *p, uint32_t n, vector_u16 value)
{
    uint16_t *const last = p + n - 8;

    for (; n >= 64; n -= 64, p += 64) {
        ETCH_UNROLL(8)
        for (uint8_t i = 0; i < 64; i = (uint8_t)(i + 8))
            vector_store(p + i, value);
    }
    switch (n >> 3) {
    case 7: vector_store(p + 48, value); /* fall through */
    case 6: vector_store(p + 40, value); /* fall through */
    case 5: vector_store(p + 32, value); /* fall through */
    case 4: vector_store(p + 24, value); /* fall through */
    case 3: vector_store(p + 16, value); /* fall through */
    case 2: vector_store(p + 8, value);  /* fall through */
    case 1: vector_store(p, value);      /* fall through */
    default: break;
    }
    vector_store(last, value);
}

/* n elements from p on. */
ETCH_INLINE void fill_row(uint16_t *p, uint32_t n, vector_u16 value)
{
    const uint64_t four = ((vector_u64)value)[0];

    if (n >= 8) {
        fill_long(p, n, value);
    } else if (n >= 4) {
        *(four_pixels *)p = four;
        *(four_pixels *)(p + n - 4) = four;
    } else if (n != 0) {
        p[0] = value[0];
        if (n != 1)
            *(two_pixels *)(p + n - 2) = (uint32_t)(four & UINT32_MAX);
    }
}

#endif
