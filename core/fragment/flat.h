/* fragment/flat.h: one colour. */
#ifndef ETCH_FRAGMENT_FLAT_H
#define ETCH_FRAGMENT_FLAT_H

#include "../base/paint.h"

struct etch_flat_paint {
    struct etch_paint paint; /* .kernel = etch_kernel_flat */
    uint16_t color;          /* in the surface's byte order */
};

etch_kernel etch_kernel_flat;

/* With 16-bit depth: a pixel whose depth passes the test against the depth plane gets colour
 * and depth. The surface must have a depth plane. */
struct etch_flat_depth_paint {
    struct etch_paint paint; /* .kernel = one of the two below */
    struct etch_plane z;     /* 16.16 + 1/2, see raster/plane.h */
    uint16_t color;
};

etch_kernel etch_kernel_flat_less;   /* passes where new < stored */
etch_kernel etch_kernel_flat_lequal; /* new <= stored */

#endif
