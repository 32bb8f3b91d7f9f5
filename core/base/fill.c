/* base/fill.c: rectangles of one value. Called by clears, rectangles and straight lines. See
 * fill.h. */
#include "fill.h"

void etch_fill_rows(uint16_t *p, uint32_t n, uint16_t value, uint32_t rows, size_t stride)
{
    const uint32_t twice = value * UINT32_C(0x10001);

    for (; rows != 0; rows--, p += stride)
        etch_fill_row(p, n, twice);
}
