/* draw/line.h: painted lines: a pixel wide with varyings, or of a width.
 *
 *      painter                               kernels
 *      etch_line_flat_depth                  etch_kernel_flat_less, _lequal
 *      etch_line_gouraud                     etch_kernel_gouraud
 *      etch_line_gouraud_depth               etch_kernel_gouraud_less, _lequal
 *
 * or a user's kernel for the same paint, as for triangles (draw/triangle.h); kernels called
 * .._swapped draw on surfaces in rgb565_swapped. In one colour without depth, etch_line_draw
 * (raster/line.h) is quicker.
 *
 * A line runs from the pixel that v[0] lies in to the pixel of v[1] and has the pixels of
 * etch_line_draw (x or y of 32768 px, the one position beyond the last pixel, counts as 32767).
 * Varyings are linear along its major axis, from one end's pixel to the other's. Each colour
 * channel is within 1/2 + 1/64 of an output step and exactly rounded at both ends; depth is within
 * 1/2 + k / 2^17 unit k pixels from the end with the smaller major coordinate, exactly rounded
 * there, and at both ends where vertices have whole depths. No value leaves the range of its two
 * ends by more than that, none wraps; both directions give the same pixels and values; clips and
 * strips change none. A line of one pixel has the mean of its ends.
 *
 * Every vertex in the ranges of base/sink.h is legal. A line without a visible pixel costs no
 * plane.
 */
#ifndef ETCH_DRAW_LINE_H
#define ETCH_DRAW_LINE_H

#include "../base/paint.h"
#include "../base/sink.h"
#include "triangle.h"

/* What the functions below have in common, so that a sink can hold any of them. */
typedef void etch_line_painter(const struct etch_surface *s, const struct etch_vertex *const v[2],
                               etch_kernel *kernel);

/* In the colour of v[0], with depth. */
etch_line_painter etch_line_flat_depth;
etch_line_painter etch_line_flat_depth_swapped;

/* Colours interpolated, and colours and depth. */
etch_line_painter etch_line_gouraud;
etch_line_painter etch_line_gouraud_depth;

/* The line from v[0] to v[1], subpixel positions and all, as a rectangle of two triangles that the
 * painter and its kernel draw: any of draw/triangle.h's. The ends are cut square. No pixel is drawn
 * twice, and lines side by side that share a long edge leave no gap.
 *
 * The rectangle is a parallelogram of vertices in 1/256 px: the way across is the exact normal of
 * length width_q8, each coordinate rounded to 1/256 px (within 1/2 + 2^-13 of it). So horizontal
 * and vertical lines have exactly their width, others within 1/256 px, wherever they are. Half of
 * it lies on each side, the odd 1/256 px where the sum of x and y is larger. Both directions cover
 * the same pixels. A line without a length or a width draws nothing. Corners beyond +-32768 px are
 * held there, which bends a line whose end is within half its width of that. */
void etch_line_wide(const struct etch_surface *s, const struct etch_vertex *const v[2],
                    uint16_t width_q8, etch_triangle_painter *painter, etch_kernel *kernel);

/* That rectangle, for what paints triangles in another way: out[0] .. out[3] round its outline, the
 * triangles 0 1 2 and 0 2 3. False, with nothing written, if the line has no length or width. */
bool etch_line_wide_corners(struct etch_vertex out[4], const struct etch_vertex *const v[2],
                            uint16_t width_q8);

#endif
