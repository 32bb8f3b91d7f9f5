/* raster/basis.c: planes of near triangles. Called by draw/ for every visible triangle; what it
 * refuses goes to plane.c. See basis.h. Here the area's reciprocal, within 2^-27 of itself (all
 * tried); the planes are in basis_color.c and basis_depth.c.
 *
 * With the differences of basis.h and d1, d2 the differences of a varying,
 *
 *      D = x1 y2 - x2 y1,   nx = d1 y2 - d2 y1,   ny = d2 x1 - d1 x2
 *
 * the slopes per pixel are 256 nx / D and 256 ny / D. D and the n are exact.
 */
#include "basis.h"
#include "../base/texture.h"

bool etch_basis_setup(struct etch_basis *b, const struct etch_triangle *t)
{
    const struct etch_point_q8 *p = t->p;
    const int32_t width = (t->x1 - t->x0) * 256 + 255, height = p[2].y - p[0].y;
    const int32_t extent = width | height;
    uint32_t d = (uint32_t)(t->area & UINT32_MAX);
    int32_t shift = 0;

    if (width + height >= INT32_C(1024) * 256)
        return false;
    if (t->area >> 32 != 0) { /* D <= width height < 2^34 */
        d = (uint32_t)(t->area >> 2);
        shift = -2;
    }
    const uint8_t zeros = etch_leading_zeros(d);

    b->shift = shift + zeros;
    b->reciprocal = etch_reciprocal_q62(d << zeros);
    b->bits = extent >> 14 == 0 ? (extent >> 12 == 0 ? 12 : 14) : (extent >> 16 == 0 ? 16 : 18);
    b->x1 = p[1].x - p[0].x;
    b->y1 = p[1].y - p[0].y;
    b->x2 = p[2].x - p[0].x;
    b->y2 = height;
    if (t->side < 0)
        b->x1 = -b->x1, b->y1 = -b->y1, b->x2 = -b->x2, b->y2 = -b->y2;
    b->ax = p[0].x >> 8;
    b->ay = p[0].y >> 8;
    b->fx = 128 - (p[0].x & 255);
    b->fy = 128 - (p[0].y & 255);
    return true;
}
