/* tradeoff/candidates.h: modes that were built to be measured and are not shipped, because another
 * is cheaper and no less exact. See README.md for what they came to. */
#ifndef TRADEOFF_CANDIDATES_H
#define TRADEOFF_CANDIDATES_H

#include "../../core/draw/triangle.h"

/* Colour planes by steps of the barycentric weights, which the channels share, in products of 32
 * bits; colours are squeezed by 1/8 step so that no error wraps round. A painter for
 * etch_kernel_gouraud. */
etch_triangle_painter candidate_triangle_fast;

/* Three channels in one word, 5.5, 6.6 and 5.5 bits, one add a pixel; set anew from the precise
 * planes at every multiple of 16 columns. A kernel for etch_triangle_gouraud. */
etch_kernel candidate_kernel_packed;

/* Quotient and remainder of each channel carried from pixel to pixel: exact without a second look.
 * A painter with a kernel of its own. */
etch_triangle_painter candidate_triangle_carried;

#endif
