/* fragment/inverse.h: 16-bit depth in a floating layout, for scenes much deeper than near.
 *
 * Linear depth (16.16 of a vertex, rounded to 16 bits) gives half of its 65,536 steps to what lies
 * between near and twice near. With near : far = 1 : 1000 a step at half way is 1/260 of the
 * distance, at 1 : 65535 it is all of it. Here a pixel keeps q = 65535.0 - z, which in perspective
 * is 1/w less 1/far, as a number with exponent and mantissa:
 *
 *      q in 16.16 = 2^e (1 + m / 2048)        code = 2048 e + m,  e = 0 .. 31, m = 0 .. 2047
 *
 * rounded to the nearest code, and stores 65535 - code: smaller is nearer, 65535 the farthest, so
 * clears and tests read as with linear depth. A step is 1/2048 to 1/4096 of q everywhere: two
 * surfaces are told apart if they are w / 2048 apart at distance w, from near to far
 * (tests/tradeoff). Vertices are those of any painter: the depth planes of a frame must all be of
 * one layout.
 *
 * Bound. With e the exponent of the triangle's greatest q and up = 30 - e, or 0 for e = 31, the
 * code is that nearest to some q within 2^-up / 64 of the exact one where x + y <= 2046, and within
 * (x + y + 1) 2^-up / 2^17 beyond: at the triangle's nearest vertex 1/2 + 1/512 of a step or less,
 * twice as much beyond 1/2 for each exponent below e. q below 2^-16 is 65535, and depths z nearer
 * than 15.0 count as 15.0.
 *
 * Source: reversed floating depth, B. Lloyd et al., "Logarithmic shadow maps", 2008, and N. Reed,
 * "Depth precision visualized", 2015. */
#ifndef ETCH_FRAGMENT_INVERSE_H
#define ETCH_FRAGMENT_INVERSE_H

#include "flat.h"
#include "gouraud.h"

/* z of these paints is the plane of q 2^up, in 16.16 + 1/2. */
struct etch_flat_inverse_paint {
    struct etch_flat_depth_paint flat; /* .paint.kernel = one of those below */
    uint8_t up;                        /* 0 .. 31 */
};

struct etch_gouraud_inverse_paint {
    struct etch_gouraud_paint gouraud;
    uint8_t up;
};

etch_kernel etch_kernel_flat_inverse_less;   /* passes where new < stored */
etch_kernel etch_kernel_flat_inverse_lequal; /* new <= stored */

etch_kernel etch_kernel_gouraud_inverse_less;
etch_kernel etch_kernel_gouraud_inverse_lequal;

/* The same for surfaces in rgb565_swapped. */
etch_kernel etch_kernel_gouraud_inverse_less_swapped;
etch_kernel etch_kernel_gouraud_inverse_lequal_swapped;

#endif
