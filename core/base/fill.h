/* base/fill.h: the innermost loop of everything flat. */
#ifndef ETCH_BASE_FILL_H
#define ETCH_BASE_FILL_H

#include "fixed.h"

#if defined(__GNUC__)
typedef uint32_t __attribute__((may_alias)) etch_pair; /* two elements stored at once */
#else
typedef uint32_t etch_pair;
#endif

/* Writes n elements of value from p on. Cost on ARMv6-M: 0.6 instructions an element for long
 * rows. */
void etch_fill(uint16_t *p, size_t n, uint16_t value);

/* The same inside a kernel, for the rows of one block; twice = value * 0x10001. Short rows, which
 * small triangles have, go straight to the last switch. */
ETCH_INLINE void etch_fill_row(uint16_t *p, uint32_t n, uint32_t twice)
{
    const uint16_t value = (uint16_t)twice;

    if (n >= 8) {
        etch_pair *q;

        if (((uintptr_t)p & 2) != 0)
            *p++ = value, n--;
        for (q = (etch_pair *)(void *)p; n >= 32; n -= 32, q += 16) {
            q[0] = twice, q[1] = twice, q[2] = twice, q[3] = twice;
            q[4] = twice, q[5] = twice, q[6] = twice, q[7] = twice;
            q[8] = twice, q[9] = twice, q[10] = twice, q[11] = twice;
            q[12] = twice, q[13] = twice, q[14] = twice, q[15] = twice;
        }
        if (n >= 16) {
            q[0] = twice, q[1] = twice, q[2] = twice, q[3] = twice;
            q[4] = twice, q[5] = twice, q[6] = twice, q[7] = twice;
            n -= 16, q += 8;
        }
        if (n >= 8) {
            q[0] = twice, q[1] = twice, q[2] = twice, q[3] = twice;
            n -= 8, q += 4;
        }
        p = (uint16_t *)(void *)q;
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
