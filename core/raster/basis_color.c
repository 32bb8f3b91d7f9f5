/* raster/basis_color.c: the colour planes of a near triangle. Called by draw/. See basis.h, and
 * basis.c for the derivation.
 *
 * The numerators n of a channel are below 2^(8 + bits). A slope is n times the area's reciprocal in
 * the channel's unit, of which 18 bits are enough: what they miss is one factor for all slopes, so
 * it counts against the change inside the triangle, at most 63 2^-17 of a step. The rest of the
 * 3/2048 that are promised is what slopes in units of 2^s lose.
 */
#include "basis.h"

/* 31 2^27 / 255 and 63 2^26 / 255 to the nearest: 255 of them are 7 and 3 units too many, which
 * is nothing against the 1/510 step between any 8-bit colour and where rounding changes. */
#define UNIT_Q27 UINT32_C(16316665)
#define UNIT_Q26 UINT32_C(16579837)

/* n factor / 2^down, rounded down: |n| < 2^(13 + down), factor < 2^18, down <= 13. */
ETCH_INLINE int32_t slope(int32_t n, int32_t factor, int32_t down)
{
    const int32_t high = n >> down, low = n - high * (INT32_C(1) << down);

    return high * factor + (int32_t)((uint32_t)low * (uint32_t)factor >> down);
}

/* v 2^s, modulo 2^32 to the left and rounded down to the right. */
ETCH_INLINE uint32_t scaled_wrap(int32_t v, int32_t s)
{
    return s >= 0 ? (uint32_t)v << s : (uint32_t)(v >> -s);
}

/* The plane of a channel that is v at vertex 0 and d1, d2 steps more at the others; its slopes are
 * hx 2^s and hy 2^s. From vertex 0 to the centre of its pixel it grows by (hx fx + hy fy) / 256. */
ETCH_INLINE void channel(struct etch_plane *plane, const struct etch_basis *b, int32_t s,
                         uint32_t v, int32_t factor, int32_t d1, int32_t d2)
{
    const int32_t down = b->bits - 5;
    const int32_t hx = slope(d1 * b->y2 - d2 * b->y1, factor, down);
    const int32_t hy = slope(d2 * b->x1 - d1 * b->x2, factor, down);
    const uint32_t dx = scaled_wrap(hx, s), dy = scaled_wrap(hy, s);

    if ((b->fx | b->fy) != 0) {
        const int32_t low = (hx & 255) * b->fx + (hy & 255) * b->fy;

        v = etch_wrap_add(v, scaled_wrap((hx >> 8) * b->fx + (hy >> 8) * b->fy + (low >> 8), s));
    }
    v = etch_wrap_sub(v, etch_wrap_mul(dx, (uint32_t)b->ax));
    plane->origin = etch_wrap_sub(v, etch_wrap_mul(dy, (uint32_t)b->ay));
    plane->dx = dx;
    plane->dy = dy;
}

/* The bytes r, g, b. */
ETCH_INLINE const uint8_t *channels(const struct etch_vertex *v)
{
    return (const uint8_t *)v + offsetof(struct etch_vertex, r);
}

bool etch_basis_color(const struct etch_basis *b, const struct etch_triangle *t,
                      const struct etch_vertex *const v[3], struct etch_plane *red,
                      struct etch_plane *green, struct etch_plane *blue)
{
    const uint8_t *c0 = channels(v[t->order[0]]), *c1 = channels(v[t->order[1]]);
    const uint8_t *c2 = channels(v[t->order[2]]);
    struct etch_plane *const planes[3] = {blue, green, red};
    const int32_t r = b->reciprocal, r_255 = (r >> 8) + (r >> 16);
    const int32_t s = b->shift + b->bits - 22; /* 256 2^24 2^13 / 2^62, and `down` */

    if (s + b->bits > 23) /* 2^s (width + height) 2^-26 is to be below 1/1024 step */
        return false;
    int32_t factor = (r - 7 * r_255) >> 13;
    uint32_t unit = UNIT_Q27, half = UINT32_C(1) << 26;

    for (int_fast8_t i = 2; i >= 0; i--) { /* r, g, b: by 31 2^3 / 255 or 63 2^2 / 255 */
        const int32_t c = *c0++;

        ETCH_KEEP(b); /* so that its fields are read where they are needed, not copied first */
        channel(planes[i], b, s, (uint32_t)c * unit + half, factor, *c1++ - c, *c2++ - c);
        if (i == 2)
            unit = UNIT_Q26, half = UINT32_C(1) << 25, factor = (r - 3 * r_255) >> 13;
        else
            unit = UNIT_Q27, half = UINT32_C(1) << 26, factor = (r - 7 * r_255) >> 13;
    }
    return true;
}
