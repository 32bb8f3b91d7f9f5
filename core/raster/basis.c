/* raster/basis.c: planes of near triangles. Called by draw/ for every visible triangle; what it
 * refuses goes to plane.c. See basis.h.
 *
 * With the differences of basis.h and d1, d2 the differences of a varying,
 *
 *      D = x1 y2 - x2 y1,   nx = d1 y2 - d2 y1,   ny = d2 x1 - d1 x2
 *
 * the slopes per pixel are 256 nx / D and 256 ny / D. D and the n are exact; 1 / D and the
 * products with it err by 2^-28 of the change that they describe, which inside the triangle is
 * at most the difference between two vertices. So only the rounding of the slopes themselves
 * grows with the distance: less than one unit a pixel, and a unit of a slope that is shifted
 * left by s counts 2^s.
 */
#include "basis.h"

/* 2^62 / d within 2^-27 for d = 2^31 .. 2^32 - 1. With d = h 2^16 + l a 17-bit quotient q of the
 * upper half, and one Newton step: e = (2^48 - d q) / 2^16 is |e| < 2^17. */
static int32_t reciprocal_of(uint32_t d)
{
    const uint32_t h = d >> 16, l = d & 0xFFFF;
    const uint32_t q = UINT32_MAX / h;
    const int32_t e = (int32_t)(UINT32_MAX - h * q + 1) - (int32_t)((l >> 1) * q >> 15);

    return (int32_t)(q << 14) + (e * (int32_t)(q >> 3) >> 15);
}

bool etch_basis_setup(struct etch_basis *b, const struct etch_triangle *t)
{
    const struct etch_point_q8 *p = t->p;
    const int32_t sign = t->side, width = (t->x1 - t->x0) * 256 + 255, height = p[2].y - p[0].y;
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
    b->bits = (uint8_t)(32 - etch_leading_zeros((uint32_t)(width | height)));
    b->x1 = sign * (p[1].x - p[0].x);
    b->y1 = sign * (p[1].y - p[0].y);
    b->x2 = sign * (p[2].x - p[0].x);
    b->y2 = sign * height;
    b->ax = p[0].x >> 8;
    b->ay = p[0].y >> 8;
    b->fx = 128 - (p[0].x & 255);
    b->fy = 128 - (p[0].y & 255);
    return true;
}

/* slope * f / 256 * 2^s, for f = -127 .. 128. */
static uint32_t offset(int32_t slope, int32_t f, int8_t s)
{
    return etch_wrap_scale((slope >> 8) * f + (((slope & 255) * f) >> 8), s);
}

void etch_basis_anchor(const struct etch_basis *b, uint32_t v0, int32_t sx, int32_t sy, int8_t s,
                       struct etch_plane *plane)
{
    const uint32_t dx = etch_wrap_scale(sx, s), dy = etch_wrap_scale(sy, s);
    uint32_t v = etch_wrap_add(v0, offset(sx, b->fx, s));

    v = etch_wrap_add(v, offset(sy, b->fy, s));
    v = etch_wrap_sub(v, etch_wrap_mul(dx, (uint32_t)b->ax));
    plane->origin = etch_wrap_sub(v, etch_wrap_mul(dy, (uint32_t)b->ay));
    plane->dx = dx;
    plane->dy = dy;
}

/* One channel: n is below 2^(8 + bits), so n 2^(23 - bits) fits, and with the factor f in it the
 * slope is mul_high(n 2^(23 - bits), f) 2^s. */
static void channel(struct etch_plane *plane, const struct etch_basis *b, uint32_t v0, int32_t d1,
                    int32_t d2, int32_t factor, int8_t s)
{
    const uint8_t up = (uint8_t)(23 - b->bits);
    const int32_t nx = d1 * b->y2 - d2 * b->y1, ny = d2 * b->x1 - d1 * b->x2;

    etch_basis_anchor(b, v0, etch_mul_high(nx * (INT32_C(1) << up), factor),
                      etch_mul_high(ny * (INT32_C(1) << up), factor), s, plane);
}

bool etch_basis_color(const struct etch_basis *b, const struct etch_triangle *t,
                      const struct etch_vertex *const v[3], struct etch_plane *red,
                      struct etch_plane *green, struct etch_plane *blue)
{
    const struct etch_vertex *const v0 = v[t->order[0]], *const v1 = v[t->order[1]];
    const struct etch_vertex *const v2 = v[t->order[2]];
    /* 31 2^27 / 255 = 16316665 - .., 63 2^26 / 255 = 16579837 - .., both below 2^24 */
    const int32_t wide = etch_mul_high(b->reciprocal, INT32_C(16316665) * 128) * 2;
    const int32_t fine = etch_mul_high(b->reciprocal, INT32_C(16579837) * 128) * 2;
    const int8_t s = (int8_t)(b->shift + b->bits - 21); /* 256 2^24 / 2^62 2^32 2^(bits - 23) */

    if (s + b->bits > 23) /* 2^s (width + height) 2^-26 is to stay below 1/1024 step */
        return false;
    channel(red, b, etch_channel_q27(v0->r), v1->r - v0->r, v2->r - v0->r, wide, s);
    channel(green, b, etch_channel_q26(v0->g), v1->g - v0->g, v2->g - v0->g, fine, s);
    channel(blue, b, etch_channel_q27(v0->b), v1->b - v0->b, v2->b - v0->b, wide, s);
    return true;
}
