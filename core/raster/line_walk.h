/* raster/line_walk.h: the innermost loop of lines; no part of the API. */
#ifndef ETCH_RASTER_LINE_WALK_H
#define ETCH_RASTER_LINE_WALK_H

#include "../base/fixed.h"

/* Draws n + 1 pixels, the first at p. From one to the next it is `along` elements, or `aside` where
 * e, which is -du .. -1, reaches 0 when dv is added; then it loses du. 0 <= 2 dv <= du. It steps
 * before it writes, so that no address past the last pixel is made.
 * Source: X. Wu, J. G. Rokne, "Double-step incremental generation of lines and circles", 1987.
 * Cost on ARMv6-M (W3): 4.9 instructions a pixel, in assembly 3.7. */
void etch_line_walk(uint16_t *p, uint32_t n, ptrdiff_t along, ptrdiff_t aside, int32_t e,
                    int32_t du, int32_t dv, uint16_t color);

#endif
