/* fragment/flat_span.h: the span of the flat kernels with depth; no part of the API. */
#ifndef ETCH_FRAGMENT_FLAT_SPAN_H
#define ETCH_FRAGMENT_FLAT_SPAN_H

#include "../base/fill.h"
#include "depth_rows.h"
#include "flat.h"

static void flat_span(uint16_t *pixel, int32_t x, uint32_t n, int32_t y,
                      const struct etch_paint *paint)
{
    (void)x, (void)y;
    etch_fill_row(pixel, n,
                  ((const struct etch_flat_depth_paint *)paint)->color * UINT32_C(0x10001));
}

#endif
