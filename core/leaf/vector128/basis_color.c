/* leaf/vector128/basis_color.c: etch_basis_color by 64-bit products, in place of
 * raster/basis_color.c, which has the derivation. Called by draw/. */
#include "../../raster/basis.h"

/* 31 2^27 / 255 and 63 2^26 / 255 to the nearest. */
#define UNIT_Q27 UINT32_C(16316665)
#define UNIT_Q26 UINT32_C(16579837)

/* v 2^s rounded down, modulo 2^32; s = -16 .. 16. */
ETCH_INLINE uint32_t scaled_wrap(int64_t v, int32_t s)
{
    return (uint32_t)((int64_t)((uint64_t)v << (s + 16)) >> 16);
}

/* The plane of a channel that is v at vertex 0 and d1, d2 steps more at the others. */
ETCH_INLINE void channel(struct etch_plane *plane, const struct etch_basis *b, int32_t s,
                         uint32_t v, int64_t factor, int32_t d1, int32_t d2)
{
    const int32_t down = b->bits - 5;
    const int64_t hx = (d1 * b->y2 - d2 * b->y1) * factor >> down;
    const int64_t hy = (d2 * b->x1 - d1 * b->x2) * factor >> down;
    const uint32_t dx = scaled_wrap(hx, s), dy = scaled_wrap(hy, s);

    if ((b->fx | b->fy) != 0)
        v = etch_wrap_add(v, scaled_wrap((hx * b->fx + hy * b->fy) >> 8, s));
    v = etch_wrap_sub(v, etch_wrap_mul(dx, (uint32_t)b->ax));
    plane->origin = etch_wrap_sub(v, etch_wrap_mul(dy, (uint32_t)b->ay));
    plane->dx = dx;
    plane->dy = dy;
}

bool etch_basis_color(const struct etch_basis *b, const struct etch_triangle *t,
                      const struct etch_vertex *const v[3], struct etch_plane *red,
                      struct etch_plane *green, struct etch_plane *blue)
{
    const struct etch_vertex *const v0 = v[t->order[0]], *const v1 = v[t->order[1]];
    const struct etch_vertex *const v2 = v[t->order[2]];
    const int32_t r = b->reciprocal, r_255 = (r >> 8) + (r >> 16);
    const int32_t s = b->shift + b->bits - 22;
    const int32_t factor = (r - 7 * r_255) >> 13, factor_green = (r - 3 * r_255) >> 13;

    if (s + b->bits > 23)
        return false;
    channel(red, b, s, v0->r * UNIT_Q27 + (UINT32_C(1) << 26), factor, v1->r - v0->r,
            v2->r - v0->r);
    channel(green, b, s, v0->g * UNIT_Q26 + (UINT32_C(1) << 25), factor_green, v1->g - v0->g,
            v2->g - v0->g);
    channel(blue, b, s, v0->b * UNIT_Q27 + (UINT32_C(1) << 26), factor, v1->b - v0->b,
            v2->b - v0->b);
    return true;
}
