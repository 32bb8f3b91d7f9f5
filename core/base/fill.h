/* base/fill.h: the innermost loop of everything flat. */
#ifndef ETCH_BASE_FILL_H
#define ETCH_BASE_FILL_H

#include "fixed.h"

#if defined(__GNUC__)
typedef uint32_t __attribute__((may_alias)) etch_pair; /* two elements stored at once */
#else
typedef uint32_t etch_pair;
#endif

/* Writes `rows` rows of n elements of value, the first from p on, `stride` elements apart; n and
 * rows are 1 or more. Cost on ARMv6-M: 0.6 instructions an element and 27 a row (W2), by
 * store-multiple (leaf/) 0.13 and 13. */
void etch_fill_rows(uint16_t *p, uint32_t n, uint16_t value, uint32_t rows, size_t stride);

/* The words from q on, in blocks of 16 and then by a switch into the last. ETCH_KEEP: gcc would
 * work out q and words again after the loop, 7 instructions a row. */
ETCH_INLINE void fill_pairs(etch_pair *q, uint32_t words, uint32_t twice)
{
    for (; words >= 16; words -= 16, q += 16) {
        q[0] = twice, q[1] = twice, q[2] = twice, q[3] = twice;
        q[4] = twice, q[5] = twice, q[6] = twice, q[7] = twice;
        q[8] = twice, q[9] = twice, q[10] = twice, q[11] = twice;
        q[12] = twice, q[13] = twice, q[14] = twice, q[15] = twice;
        ETCH_KEEP(q);
        ETCH_KEEP(words);
    }
    switch (words) {
    case 15: q[14] = twice; /* fall through */
    case 14: q[13] = twice; /* fall through */
    case 13: q[12] = twice; /* fall through */
    case 12: q[11] = twice; /* fall through */
    case 11: q[10] = twice; /* fall through */
    case 10: q[9] = twice;  /* fall through */
    case 9: q[8] = twice;   /* fall through */
    case 8: q[7] = twice;   /* fall through */
    case 7: q[6] = twice;   /* fall through */
    case 6: q[5] = twice;   /* fall through */
    case 5: q[4] = twice;   /* fall through */
    case 4: q[3] = twice;   /* fall through */
    case 3: q[2] = twice;   /* fall through */
    case 2: q[1] = twice;   /* fall through */
    case 1: q[0] = twice;   /* fall through */
    default: break;
    }
}

/* n elements from p on, for the rows of one block; twice = value * 0x10001. Short rows, which
 * small triangles have, go straight to the last switch. */
ETCH_INLINE void etch_fill_row(uint16_t *p, uint32_t n, uint32_t twice)
{
    const uint16_t value = (uint16_t)twice;

    if (n >= 8) {
        if (((uintptr_t)p & 2) != 0)
            *p++ = value, n--;

        etch_pair *const pairs = (etch_pair *)(void *)p;
        const uint32_t words = n >> 1;

        if ((n & 1) != 0)
            *(uint16_t *)(void *)(pairs + words) = value;
        fill_pairs(pairs, words, twice);
        return;
    }
    switch (n) {
    case 7: p[6] = value; /* fall through */
    case 6: p[5] = value; /* fall through */
    case 5: p[4] = value; /* fall through */
    case 4: p[3] = value; /* fall through */
    case 3: p[2] = value; /* fall through */
    case 2: p[1] = value; /* fall through */
    case 1: p[0] = value; /* fall through */
    default: break;
    }
}

#endif
