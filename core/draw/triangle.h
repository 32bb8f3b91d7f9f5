/* draw/triangle.h: painted triangles: set-up, planes and the edge walk joined.
 *
 * A painter sets up the planes that its kernels read, the kernel does the pixel work:
 *
 *      painter                               kernels
 *      etch_triangle_flat                    etch_kernel_flat
 *      etch_triangle_flat_depth              etch_kernel_flat_less, _lequal
 *      etch_triangle_gouraud                 etch_kernel_gouraud
 *      etch_triangle_gouraud_depth           etch_kernel_gouraud_less, _lequal
 *
 * or a user's kernel for the same paint (fragment/flat.h, gouraud.h). Another pair is a caller's
 * bug: the kernel would read data that the painter did not set. Kernels with a depth test need a
 * surface with a depth plane.
 *
 * On a surface in rgb565_swapped the bytes are exchanged where the colour is made: once a triangle
 * by etch_triangle_flat_swapped and etch_triangle_flat_depth_swapped, once a pixel by the
 * kernels called etch_kernel_gouraud.._swapped.
 *
 * A triangle without visible rows or columns costs no plane. Every vertex in the ranges of
 * base/sink.h is legal; zero area draws nothing; both windings draw (cull before, vertex/cull.h).
 */
#ifndef ETCH_DRAW_TRIANGLE_H
#define ETCH_DRAW_TRIANGLE_H

#include "../base/paint.h"
#include "../base/sink.h"
#include "../fragment/barycentric.h"

/* What the functions below have in common, so that a sink can hold any of them. */
typedef void etch_triangle_painter(const struct etch_surface *s,
                                   const struct etch_vertex *const v[3], etch_kernel *kernel);

/* In the colour of v[0], rounded to RGB565. */
etch_triangle_painter etch_triangle_flat;
etch_triangle_painter etch_triangle_flat_swapped;

/* The same with a depth plane, interpolated linearly on the screen. */
etch_triangle_painter etch_triangle_flat_depth;
etch_triangle_painter etch_triangle_flat_depth_swapped;

/* Colours interpolated linearly on the screen. */
etch_triangle_painter etch_triangle_gouraud;

/* Colours and depth interpolated. */
etch_triangle_painter etch_triangle_gouraud_depth;

/* color(context, x, y, b) for every pixel of the triangle. */
void etch_triangle_barycentric(const struct etch_surface *s, const struct etch_vertex *const v[3],
                               etch_barycentric_function *color, void *context);

/* One colour, vertices in 16.16 px, snapped to 1/256. Every input is legal. */
struct etch_point_q16 {
    etch_q16 x, y;
};
void etch_triangle_fill_q16(const struct etch_surface *s, const struct etch_point_q16 v[3],
                            uint16_t color);

#endif
