/* frame/move.h: rectangles of pixels to another place, in one surface or between two.
 *
 * Rectangles and places are the frame's. Pixels come from the memory of a surface, its window, and
 * go inside the clip: so these need what they read in memory, a framebuffer or an image of their
 * own. On strips, draw again instead. Both surfaces are in one byte order. Cost: base/copy.h, and
 * some 60 instructions a call. frame/exchange.h has whole surfaces onto one another.
 */
#ifndef ETCH_FRAME_MOVE_H
#define ETCH_FRAME_MOVE_H

#include "../base/surface.h"

/* What is in `area` of `from` goes to where (x, y) is its upper left pixel, on `to`. Pixels that
 * the window of `from` does not hold and those outside the clip of `to` stay. The two may be the
 * same surface, or surfaces with one stride over the same memory: every pixel then gets what was at
 * its source before the call, also where the areas overlap. */
void etch_surface_copy_rect(const struct etch_surface *to, int16_t x, int16_t y,
                            const struct etch_surface *from, struct etch_rect area);

/* Moves what is in `area` by dx to the right and dy down; what goes out of the area is lost, and
 * where nothing comes from is filled with `color`. Each pixel of the area in the clip is written
 * once. */
void etch_surface_scroll(const struct etch_surface *s, struct etch_rect area, int16_t dx,
                         int16_t dy, uint16_t color);

/* Exclusive or of every pixel of the rectangle (x, y, w, h) with `mask`: the same call again takes
 * it away, whatever is below. For cursors and rubber bands; cursors of a shape: etch_row_index1_xor
 * in draw/image.h. */
void etch_rect_xor(const struct etch_surface *s, int16_t x, int16_t y, int16_t w, int16_t h,
                   uint16_t mask);

#endif
