/* frame/exchange.h: rows from surface to surface.
 *
 * All work on the frame's pixels that both clips share, so a surface whose window is a strip takes
 * a strip's part. To take pixels from another place of the same frame, make a surface over them
 * that is told the window of the destination. Both surfaces are in one byte order; rows must not
 * overlap in memory, but the two may be the same: then exchange and copy change nothing.
 */
#ifndef ETCH_FRAME_EXCHANGE_H
#define ETCH_FRAME_EXCHANGE_H

#include "../base/surface.h"

/* to = from. */
void etch_surface_copy(const struct etch_surface *to, const struct etch_surface *from);

/* to ^= from: twice is nothing, which moves a cursor without a copy of what is under it. */
void etch_surface_xor(const struct etch_surface *to, const struct etch_surface *from);

/* a ^= b, b ^= a, a ^= b: the two images change places, without memory for a third. The classic
 * use of the raster operation; two loads and two stores a pixel. */
void etch_surface_exchange(const struct etch_surface *a, const struct etch_surface *b);

#endif
