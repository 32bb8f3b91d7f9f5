/* raster/basis.c: planes of near triangles. Called by draw/ for every visible triangle; what it
 * refuses goes to plane.c. See basis.h. Here the shared reciprocal; the planes are in basis_color.c
 * and basis_depth.c.
 *
 * With the differences of basis.h and d1, d2 the differences of a varying,
 *
 *      D = x1 y2 - x2 y1,   nx = d1 y2 - d2 y1,   ny = d2 x1 - d1 x2
 *
 * the slopes per pixel are 256 nx / D and 256 ny / D. D and the n are exact.
 */
#include "basis.h"

/* 2^62 / d for d = 2^31 .. 2^32 - 1 and its upper half h: from the best straight line, 1/17 off,
 * three Newton steps q += q (1 - q h / 2^32), the last with all of d. Each squares the relative
 * error: 2^-4, 2^-8, 2^-15.6, and 2^-27.9 with what the shifts drop (all d tried). */
static int32_t reciprocal_of(uint32_t d)
{
    const uint32_t h = d >> 16, l = d & 0xFFFF;
    int32_t q = 185043 - (int32_t)(h * 30840 >> 14); /* 48/17 - 32/17 h, below 2^17.5 */
    int32_t e = (int32_t)etch_wrap_sub(0, etch_wrap_mul(h, (uint32_t)q));

    q += q * (e >> 15) >> 17; /* |e| < 2^28 */
    e = (int32_t)etch_wrap_sub(0, etch_wrap_mul(h, (uint32_t)q));
    q += q * (e >> 11) >> 21; /* |e| < 2^24 */
    e = (int32_t)etch_wrap_sub(0, etch_wrap_mul(h, (uint32_t)q));
    e -= (int32_t)((l >> 1) * (uint32_t)q >> 15); /* (2^48 - d q) / 2^16, |e| < 2^17 */
    return q * 16384 + (e * (q >> 3) >> 15);
}

bool etch_basis_setup(struct etch_basis *b, const struct etch_triangle *t)
{
    const struct etch_point_q8 *p = t->p;
    const int32_t width = (t->x1 - t->x0) * 256 + 255, height = p[2].y - p[0].y;
    const int32_t extent = width | height;
    uint32_t d = (uint32_t)(t->area & UINT32_MAX);
    int8_t shift = 0;

    if (width + height >= INT32_C(1024) * 256)
        return false;
    if (t->area >> 32 != 0) { /* D <= width height < 2^34 */
        d = (uint32_t)(t->area >> 2);
        shift = -2;
    }
    const uint8_t zeros = etch_leading_zeros(d);

    b->shift = (int8_t)(shift + zeros);
    b->reciprocal = reciprocal_of(d << zeros);
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
