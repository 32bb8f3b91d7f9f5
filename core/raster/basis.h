/* raster/basis.h: planes of near triangles by one reciprocal of the area.
 *
 * plane.h is exact for every triangle but divides in 64 bits. A triangle whose width and height
 * add up to less than 1024 px keeps more than the promise (colour within 1/2 + 3/2048 step and
 * inside the rounded range of its vertices, depth within 1/2 + 1/64 unit) with one 32-bit
 * reciprocal and a few products per plane. Such planes are anchored at the topmost vertex, so they
 * do not depend on where on the frame the triangle lies. Slivers for which 32 bits are too few say
 * so and take the way of plane.h; which way is taken depends on the triangle alone, never on the
 * clip.
 */
#ifndef ETCH_RASTER_BASIS_H
#define ETCH_RASTER_BASIS_H

#include "plane.h"

struct etch_basis {
    int32_t x1, y1, x2, y2; /* vertices 1 and 2 against 0, 1/256 px, signed so that D > 0 */
    int32_t reciprocal;     /* 2^62 / (D 2^shift), 2^30 .. 2^31 - 1, within 2^-27 of itself */
    int32_t shift;          /* brings D into 2^31 .. 2^32 - 1 */
    int32_t bits;           /* extents are below 2^bits: 12, 14, 16 or 18 */
    int32_t ax, ay;         /* the pixel of vertex 0 */
    int32_t fx, fy;         /* from vertex 0 to that pixel's centre, 1/256 px, -127 .. 128 */
};

/* v 2^s, modulo 2^32 to the left and rounded to nearest to the right; s = -31 .. 31. */
ETCH_INLINE uint32_t basis_wrap_scale(int32_t v, int32_t s)
{
    return s >= 0 ? (uint32_t)v << s : (uint32_t)(v >> -s) + (uint32_t)(v >> (-s - 1) & 1);
}

/* False if the triangle is not near; then use plane.h. */
bool etch_basis_setup(struct etch_basis *b, const struct etch_triangle *t);

/* The planes of the colours of the caller's vertices. False for slivers. */
bool etch_basis_color(const struct etch_basis *b, const struct etch_triangle *t,
                      const struct etch_vertex *const v[3], struct etch_plane *red,
                      struct etch_plane *green, struct etch_plane *blue);

/* The plane of their depths. False for slivers. */
bool etch_basis_depth(const struct etch_basis *b, const struct etch_triangle *t,
                      const struct etch_vertex *const v[3], struct etch_plane *z);

#endif
