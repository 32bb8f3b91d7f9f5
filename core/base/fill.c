/* base/fill.c: rows of one value. Called by the flat kernel and the clears. See fill.h. */
#include "fill.h"

void etch_fill(uint16_t *p, uint16_t n, uint16_t value)
{
    for (; n >= 8; n = (uint16_t)(n - 8), p += 8) {
        p[0] = value, p[1] = value, p[2] = value, p[3] = value;
        p[4] = value, p[5] = value, p[6] = value, p[7] = value;
    }
    for (; n != 0; n--)
        *p++ = value;
}
