/* raster/basis_depth.c: the depth plane of a near triangle. Called by draw/. See basis.h, and
 * basis.c for the derivation.
 *
 * Depths are taken in 16.15 so that a difference fits 32 bits. The products n are kept below
 * 2^31: by dropping up to 7 bits of the differences, 2^-8 of a unit, or else in 64 bits.
 */
#include "basis.h"

static int32_t bits_of(int32_t a, int32_t b)
{
    return 32 - etch_leading_zeros((uint32_t)((a < 0 ? -a : a) | (b < 0 ? -b : b)));
}

/* The products in 64 bits, below 2^50, brought below 2^30, or to it where a negative one rounds
 * down: n[0], n[1] count 2^result. */
static uint8_t products_wide(const struct etch_basis *b, int32_t d1, int32_t d2, int32_t n[2])
{
    const int64_t x = etch_mul_s32(d1, b->y2) - etch_mul_s32(d2, b->y1);
    const int64_t y = etch_mul_s32(d2, b->x1) - etch_mul_s32(d1, b->x2);
    const uint64_t both = (uint64_t)(x < 0 ? -x : x) | (uint64_t)(y < 0 ? -y : y);
    const uint8_t down = (uint8_t)(32 - etch_leading_zeros((uint32_t)(both >> 30)));

    n[0] = (int32_t)(x >> down);
    n[1] = (int32_t)(y >> down);
    return down;
}

static uint8_t products(const struct etch_basis *b, int32_t d1, int32_t d2, int32_t n[2])
{
    const int32_t bits = bits_of(d1, d2) + b->bits;
    const uint8_t drop = (uint8_t)(bits > 30 ? bits - 30 : 0);

    if (drop > 7)
        return products_wide(b, d1, d2, n);
    d1 >>= drop, d2 >>= drop;
    n[0] = d1 * b->y2 - d2 * b->y1;
    n[1] = d2 * b->x1 - d1 * b->x2;
    return drop;
}

/* v 2^up of either sign, which fits. */
static int32_t shifted_wrap(int32_t v, int32_t up)
{
    return (int32_t)((uint32_t)v << up);
}

/* The plane with slopes sx 2^s and sy 2^s per pixel, |sx|, |sy| < 2^30, that is v0 at vertex 0;
 * s = -31 .. 31. From there to the centre of its pixel it grows by (sx fx + sy fy) / 256. */
static void anchor(const struct etch_basis *b, uint32_t v0, int32_t sx, int32_t sy, int32_t s,
                   struct etch_plane *plane)
{
    const int32_t low = (sx & 255) * b->fx + (sy & 255) * b->fy;
    const int32_t grows = (sx >> 8) * b->fx + (sy >> 8) * b->fy + (low >> 8);
    const uint32_t dx = basis_wrap_scale(sx, s), dy = basis_wrap_scale(sy, s);
    uint32_t v = etch_wrap_add(v0, basis_wrap_scale(grows, s));

    v = etch_wrap_sub(v, etch_wrap_mul(dx, (uint32_t)b->ax));
    plane->origin = etch_wrap_sub(v, etch_wrap_mul(dy, (uint32_t)b->ay));
    plane->dx = dx;
    plane->dy = dy;
}

bool etch_basis_depth(const struct etch_basis *b, const struct etch_triangle *t,
                      const struct etch_vertex *const v[3], struct etch_plane *z)
{
    const uint32_t z0 = etch_depth_q16(v[t->order[0]]->z_q16);
    const int32_t d1 = (int32_t)(etch_depth_q16(v[t->order[1]]->z_q16) >> 1) - (int32_t)(z0 >> 1);
    const int32_t d2 = (int32_t)(etch_depth_q16(v[t->order[2]]->z_q16) >> 1) - (int32_t)(z0 >> 1);
    int32_t n[2];
    const uint8_t down = products(b, d1, d2, n);
    const int32_t used = bits_of(n[0], n[1]), spare = used != 0 ? 31 - used : 0;
    /* 2 * 256 / 2^62 * 2^32 */
    const int32_t s = b->shift - 21 + down - spare;

    if (s + b->bits > 16) /* 2^s (width + height) 2^-16 is to stay below 1/128 unit */
        return false;
    anchor(b, z0, etch_mul_high(shifted_wrap(n[0], spare), b->reciprocal),
           etch_mul_high(shifted_wrap(n[1], spare), b->reciprocal), s < -31 ? -31 : s, z);
    return true;
}
