/* fragment/depth_rows.h: depth first, colour after; no part of the API.
 *
 * A kernel with depth finds the spans of pixels that pass, writes their depths and hands them on to
 * what gives them colour. Most pixels of a deep scene fail, so the loop over them is the one that
 * counts: here it is alone, and the same for flat, interpolated and textured pixels.
 *
 *      runs -> scan to the first pixel that passes -> write depths while they pass -> span
 */
#ifndef ETCH_FRAGMENT_DEPTH_ROWS_H
#define ETCH_FRAGMENT_DEPTH_ROWS_H

#include "template.h"

/* Gives colour to the pixels x .. x + n - 1 of row y, the first at `pixel`; n > 0. */
typedef void etch_span(uint16_t *pixel, int32_t x, uint32_t n, int32_t y,
                       const struct etch_paint *paint);

/* As a kernel is called, with one that tests and writes depth and then calls `span`. The paint
 * begins as struct etch_depth_paint. Cost on ARMv6-M a pixel that fails: 5.4 instructions (W10), in
 * assembly (leaf/) 4.2. */
typedef void etch_depth_rows(const struct etch_surface *surface, int16_t y0,
                             const struct etch_run *runs, uint8_t n, const struct etch_paint *paint,
                             etch_span *span);

etch_depth_rows etch_depth_rows_less;   /* passes where new < stored */
etch_depth_rows etch_depth_rows_lequal; /* new <= stored */

#endif
