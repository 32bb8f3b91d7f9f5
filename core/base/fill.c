/* base/fill.c: rows of one value. Called by clears and straight lines. See fill.h. */
#include "fill.h"

void etch_fill(uint16_t *p, size_t n, uint16_t value)
{
    etch_fill_row(p, (uint32_t)n, value * UINT32_C(0x10001));
}
