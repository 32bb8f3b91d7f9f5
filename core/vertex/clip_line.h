/* vertex/clip_line.h: lines in clip space, cut at planes.
 *
 * By Liang and Barsky: a plane that the line enters moves its beginning, one that it leaves moves
 * its end; of several the last entry and the first exit count. Parameters are ordered by the sign
 * of products of distances, exactly and without a division.
 *
 * A cut follows from the line's two ends and one plane alone, whichever end is inside and whatever
 * else was cut: it is the corner that etch_clip_triangle (clip.h) finds on the same edge and plane,
 * bit for bit, with the same precision. So drawn edges stay on the triangles that they belong to.
 * Source: Y.-D. Liang, B. Barsky, "A new concept and method for line clipping", 1984.
 */
#ifndef ETCH_VERTEX_CLIP_LINE_H
#define ETCH_VERTEX_CLIP_LINE_H

#include "viewport.h"

/* The part of the line v[0] v[1] inside near, far and the guard planes of `viewport`, in its
 * direction; the sides are left to the rasteriser's scissor. False if there is none (then out is
 * not to be used). Each end has w > 0 and can be projected; an end that is inside is copied, the
 * x, y, z, w of a new one have a scale of their own (only their ratios have a meaning). Every input
 * is legal; a line that only touches a plane from outside becomes one point. */
bool etch_clip_line(const struct etch_viewport *viewport, const struct etch_clip_vertex v[2],
                    struct etch_clip_vertex out[2]);

/* The same against all six planes of the volume -w <= x, y, z <= w: what is left lies in the
 * viewport. A cut at a side is rounded to 1/256 px when it is projected, so the pixels of the line
 * may differ from those that the scissor leaves. */
bool etch_clip_line_volume(const struct etch_clip_vertex v[2], struct etch_clip_vertex out[2]);

#endif
