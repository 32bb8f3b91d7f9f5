/* leaf/vector128/fill.c: etch_fill_rows by vectors, in place of base/fill.c. Called by clears,
 * rectangles and straight lines. */
#include "../../base/fill.h"
#include "fill_row.h"

void etch_fill_rows(uint16_t *p, uint32_t n, uint16_t value, uint32_t rows, size_t stride)
{
    const vector_u16 vector = (vector_u16)vector_all(value * UINT32_C(0x10001));

    for (; rows != 0; rows--, p += stride)
        fill_row(p, n, vector);
}
