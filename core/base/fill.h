/* base/fill.h: the innermost loop of everything flat. */
#ifndef ETCH_BASE_FILL_H
#define ETCH_BASE_FILL_H

#include "fixed.h"

/* Writes n elements of value from p on. Cost on ARMv6-M: 0.6 instructions an element for long
 * rows. */
void etch_fill(uint16_t *p, uint16_t n, uint16_t value);

#endif
