/* raster/basis_color.c: the colour planes of a near triangle. Called by draw/. See basis.h, and
 * basis.c for the derivation.
 *
 * The numerators n of a channel are below 2^(8 + bits), so n 2^(23 - bits) fits. With the unit of
 * the channel in the factor f, the slopes are the upper halves of n 2^(23 - bits) f, times 2^s.
 */
#include "basis.h"

/* 31 2^27 / 255 and 63 2^26 / 255 to the nearest: 255 of them are 7 and 3 units too many, which
 * is nothing against the 1/510 step between any 8-bit colour and where rounding changes. */
#define UNIT_Q27 INT32_C(16316665)
#define UNIT_Q26 INT32_C(16579837)

/* s: 256 2^24 / 2^62 2^32 2^(bits - 23), with the shift of the area. */
ETCH_INLINE int32_t color_scale(const struct etch_basis *b)
{
    return b->shift + b->bits - 21;
}

/* The plane of a channel that is plane->origin at vertex 0 and d1, d2 steps more at the others. From
 * vertex 0 to the centre of its pixel the channel grows by (hx fx + hy fy) / 256, times 2^s. */
static void channel(struct etch_plane *plane, const struct etch_basis *b, int32_t factor,
                    int32_t d1, int32_t d2)
{
    const int32_t s = color_scale(b), up = INT32_C(1) << (23 - b->bits);
    const int32_t hx = etch_mul_high((d1 * b->y2 - d2 * b->y1) * up, factor);
    const int32_t hy = etch_mul_high((d2 * b->x1 - d1 * b->x2) * up, factor);
    const uint32_t dx = basis_wrap_scale(hx, s), dy = basis_wrap_scale(hy, s);
    uint32_t v = plane->origin;

    if ((b->fx | b->fy) != 0) {
        const int32_t low = (hx & 255) * b->fx + (hy & 255) * b->fy;

        v = etch_wrap_add(v,
                          basis_wrap_scale((hx >> 8) * b->fx + (hy >> 8) * b->fy + (low >> 8), s));
    }
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
    /* the reciprocal times 31 2^3 / 255 and 63 2^2 / 255 */
    const int32_t r = b->reciprocal, r_255 = (r >> 8) + (r >> 16) + (r >> 24);
    const int32_t wide = r - 7 * r_255, fine = r - 3 * r_255;

    if (color_scale(b) + b->bits > 23) /* 2^s (width + height) 2^-26 is to be below 1/1024 step */
        return false;
    red->origin = v0->r * (uint32_t)UNIT_Q27 + (UINT32_C(1) << 26);
    green->origin = v0->g * (uint32_t)UNIT_Q26 + (UINT32_C(1) << 25);
    blue->origin = v0->b * (uint32_t)UNIT_Q27 + (UINT32_C(1) << 26);
    channel(red, b, wide, v1->r - v0->r, v2->r - v0->r);
    channel(green, b, fine, v1->g - v0->g, v2->g - v0->g);
    channel(blue, b, wide, v1->b - v0->b, v2->b - v0->b);
    return true;
}
