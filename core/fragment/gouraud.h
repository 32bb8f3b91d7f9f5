/* fragment/gouraud.h: colour interpolated linearly on the screen, one plane a channel.
 * Rounds to the nearest RGB565 step of the interpolated value. */
#ifndef ETCH_FRAGMENT_GOURAUD_H
#define ETCH_FRAGMENT_GOURAUD_H

#include "../base/paint.h"

struct etch_gouraud_paint {
    struct etch_paint paint;   /* .kernel = one of those below */
    struct etch_plane z;       /* 16.16 + 1/2; read by the depth kernels only */
    struct etch_plane r, g, b; /* 5.27, 6.26, 5.27, each + 1/2; see raster/plane.h */
};

etch_kernel etch_kernel_gouraud;
etch_kernel etch_kernel_gouraud_less;
etch_kernel etch_kernel_gouraud_lequal;

/* The same for surfaces in rgb565_swapped. */
etch_kernel etch_kernel_gouraud_swapped;
etch_kernel etch_kernel_gouraud_less_swapped;
etch_kernel etch_kernel_gouraud_lequal_swapped;

#endif
