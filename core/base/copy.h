/* base/copy.h: the innermost loop of everything that moves pixels as they are. */
#ifndef ETCH_BASE_COPY_H
#define ETCH_BASE_COPY_H

#include "fixed.h"

/* Where rectangles of elements come from and go to. */
struct etch_copy {
    uint16_t *to;
    const uint16_t *from;
    size_t to_stride, from_stride; /* elements from one row to the next */
};

/* Copies `rows` rows of n elements; n and rows are 1 or more. The two may overlap if the strides
 * are equal: what arrives is what was there before. Cost on ARMv6-M, in long rows: 1.3 instructions
 * an element where both rows begin on the same side of a word, else 2.5. */
void etch_copy_rows(const struct etch_copy *c, uint32_t n, uint32_t rows);

/* One row of n elements, 1 or more, from the first to the last: `to` may lie below `from`. */
void etch_copy_row(uint16_t *to, const uint16_t *from, uint32_t n);

#endif
