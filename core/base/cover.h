/* base/cover.h: what smooth shapes hand to the fragment stage: the share of each pixel that they
 * cover. */
#ifndef ETCH_BASE_COVER_H
#define ETCH_BASE_COVER_H

#include "surface.h"

#define ETCH_COVER_ONE 4096

struct etch_cover_paint;

/* Takes the covers of pixels x .. x + n - 1 of row y, all inside surface->clip, each 1 .. 4096.
 * Pixels come once, by rows, from left to right. */
typedef void etch_cover_kernel(const struct etch_surface *surface, int16_t x, int16_t y, uint16_t n,
                               const int16_t *cover, const struct etch_cover_paint *paint);

/* The head of a paint for covers; the kernel finds its data behind it. */
struct etch_cover_paint {
    etch_cover_kernel *kernel;
};

#endif
