/* raster/texture_plane.h: texture coordinates of a triangle, affine and in perspective.
 *
 * Like all set-up it depends on the triangle alone, not on the order of its vertices nor on clips,
 * and is anchored to the frame. `basis` is that of the triangle, or NULL if it is not near.
 */
#ifndef ETCH_RASTER_TEXTURE_PLANE_H
#define ETCH_RASTER_TEXTURE_PLANE_H

#include "../base/texture.h"
#include "basis.h"

/* The plane through value[i] < 2^31 at the caller's vertex i, in any format: by the basis, or
 * exactly (raster/plane.h) where there is none or it refuses. A near plane errs by less than one
 * unit for each pixel of width and height, and 8 units and 2^-26 of the span. */
void etch_texture_plane(struct etch_plane *plane, const struct etch_triangle *t,
                        const struct etch_basis *basis, const uint32_t value[3]);

/* The planes of u (12.20) and v (texels 2^(16 + width_bits)), modulo 2^32. No coordinate leaves the
 * range of the vertices where x + y < 1000 (16000 if the texture is 16 texels wide or more): the
 * ends of the range are moved inwards by what the planes may err, 1/128 texel at most. So a
 * coordinate errs by less than 1/64 texel where x + y <= 2046 and the texture is 2 texels wide or
 * more (1/32: one texel wide), as long as the coordinate spans less than 2048 texels on the
 * triangle; beyond, a bit is lost for each doubling. Equal coordinates stay exactly equal. */
void etch_texture_affine(struct etch_plane *u, struct etch_plane *v, const struct etch_triangle *t,
                         const struct etch_basis *basis,
                         const struct etch_texture_vertex *const vertex[3], uint8_t width_bits);

/* One of the two by itself: the coordinate c[i] of the caller's vertex i, 16.16, as a plane with
 * `extra` more bits, 0 .. 12, modulo 2^32. */
void etch_texture_axis(struct etch_plane *plane, const struct etch_triangle *t,
                       const struct etch_basis *basis, const etch_q16 c[3], uint8_t extra);

/* The planes of u/w, v/w and 1/w. True if the triangle may be drawn with a divide every 16 pixels:
 * if in no block that it touches 1/w falls below half of its least vertex, nor a coordinate changes
 * by more than 4096 texels. Otherwise every pixel needs its divide.
 *
 * With R the ratio of the greatest w to the least and S the span of a coordinate in texels, what
 * comes out at a pixel of the triangle errs by at most
 *      S (R (L + 32) 2^-28 + 2^-25) + 2^-12 texels,
 * L the greater of (x + y) / 2 and, if the triangle is near, its width and height in pixels. */
bool etch_texture_perspective(struct etch_perspective_planes *p, const struct etch_triangle *t,
                              const struct etch_basis *basis,
                              const struct etch_texture_vertex *const vertex[3]);

#endif
