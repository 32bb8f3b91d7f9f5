/* fragment/dither.h: interpolated colour, dithered in order to RGB565.
 *
 * RGB565 shows 32 or 64 levels where vertices have 256: a slow ramp shows steps. Here every pixel
 * adds a threshold of its own to the interpolated value, t = (2 b + 1) / 128 with b = 0 .. 63 by
 * Bayer's matrix of 8 x 8, and takes floor(value + t): of a constant colour, as many of 64 pixels
 * go up as its fraction says. The matrix is anchored at the frame, so strips and clips change no
 * pixel.
 *
 * Bounds. A pixel is floor(v + t) for some v within 1/64 step of the exact value; so it is less
 * than one step off, never outside floor(least) .. ceil(greatest vertex), and a channel that is a
 * whole step all over stays that. The mean of an aligned 8 x 8 block of constant colour errs by at
 * most 1/128 step.
 *
 * Source: B. E. Bayer, "An optimum method for two-level rendition of continuous-tone pictures",
 * 1973. Paints and painters are those of gouraud.h (draw/triangle.h). */
#ifndef ETCH_FRAGMENT_DITHER_H
#define ETCH_FRAGMENT_DITHER_H

#include "depth_rows.h"
#include "gouraud.h"

etch_kernel etch_kernel_gouraud_dither;
etch_kernel etch_kernel_gouraud_dither_less;
etch_kernel etch_kernel_gouraud_dither_lequal;

/* The same for surfaces in rgb565_swapped. */
etch_kernel etch_kernel_gouraud_dither_swapped;
etch_kernel etch_kernel_gouraud_dither_less_swapped;
etch_kernel etch_kernel_gouraud_dither_lequal_swapped;

/* A span of these kernels. */
etch_span etch_gouraud_dither_span, etch_gouraud_dither_span_swapped;

/* 2 b + 1 for the pixels of column x modulo 8 in row y modulo 8. */
extern const uint8_t etch_dither_bayer[8][8];

#endif
