/* raster/texture_perspective.c: texture coordinates in perspective. Called by draw/. See
 * texture_plane.h.
 *
 * What is linear on the screen is 1/w and u/w. Scaled so that the greatest 1/w is q = 2^29 .. 2^30,
 * and u taken against the middle of the vertices, |u| <= 2^31,
 *
 *      denominator = q,   numerator = u q / 2^e,   e such that |numerator| < 2^29,
 *
 * the coordinate is middle + numerator / denominator 2^e. Errors of q are relative to each vertex
 * and as small as those of the reciprocal; errors of the planes weigh R = greatest w / least w
 * times as much at the farthest vertex as at the nearest.
 */
#include "texture_plane.h"

/* q[i] = 2^30 least w / w[i], at least 1. */
static void inverses(int32_t q[3], const struct etch_texture_vertex *const vertex[3])
{
    uint8_t zeros[3], most = 0;

    for (uint8_t i = 0; i < 3; i++) {
        const uint32_t w = vertex[i]->w != 0 ? vertex[i]->w : 1;

        zeros[i] = etch_leading_zeros(w);
        most = zeros[i] > most ? zeros[i] : most;
        q[i] = etch_reciprocal_q62(w << zeros[i]);
    }
    for (uint8_t i = 0; i < 3; i++) {
        q[i] >>= most - zeros[i] < 30 ? most - zeros[i] + 1 : 31;
        q[i] = q[i] > 0 ? q[i] : 1;
    }
}

/* True if 256 |n| / D < limit; n = |v1 y2 - v2 y1| is the slope along a row, |v| < 2^31, and below
 * 2^56. limit <= 2^25. */
static bool rises_less(const struct etch_triangle *t, const int32_t value[3], int32_t limit)
{
    const int32_t v0 = value[t->order[0]];
    const int64_t n = etch_mul_s32(value[t->order[1]] - v0, t->p[2].y - t->p[0].y) -
                      etch_mul_s32(value[t->order[2]] - v0, t->p[1].y - t->p[0].y);

    return (uint64_t)(n < 0 ? -n : n) >> 2 < (t->area >> 2) * (uint32_t)(limit >> 8);
}

/* A signed value's plane: biased by 2^29 meanwhile. */
static void signed_plane(struct etch_plane *plane, const struct etch_triangle *t,
                         const struct etch_basis *basis, const int32_t value[3])
{
    uint32_t biased[3];

    for (uint8_t i = 0; i < 3; i++)
        biased[i] = (uint32_t)(value[i] + (INT32_C(1) << 29));
    etch_texture_plane(plane, t, basis, biased);
    plane->origin = etch_wrap_sub(plane->origin, UINT32_C(1) << 29);
}

/* The numerators of u - middle, and e = 3 .. 32; |u - middle| q < 2^61. */
static int8_t numerators(int32_t value[3], const etch_q16 c[3], const int32_t q[3], uint32_t middle)
{
    uint64_t all = 0;
    int64_t product[3];

    for (uint8_t i = 0; i < 3; i++) {
        const int32_t offset = (int32_t)etch_wrap_sub((uint32_t)c[i], middle);

        product[i] = etch_mul_s32(offset, q[i]);
        all |= (uint64_t)(product[i] < 0 ? -product[i] : product[i]);
    }
    const uint32_t high = (uint32_t)(all >> 29);
    const int8_t bits = (int8_t)(32 - etch_leading_zeros(high)), e = bits > 3 ? bits : 3;

    for (uint8_t i = 0; i < 3; i++)
        value[i] = (int32_t)(product[i] >> e);
    return e;
}

/* One coordinate. True if blocks are possible: it spans less than 8192 texels and changes by less
 * than 4096 in 16 pixels even where 1/w is half its least, as
 *      16 slope 2^e / (least / 2) < 2^28  <=>  slope < least 2^(23 - e). */
static bool axis(struct etch_perspective_axis *a, const struct etch_triangle *t,
                 const struct etch_basis *basis, const etch_q16 c[3], const int32_t q[3],
                 int32_t least_q)
{
    etch_q16 least = c[0], most = c[0];
    int32_t value[3];

    for (uint8_t i = 1; i < 3; i++) {
        least = c[i] < least ? c[i] : least;
        most = c[i] > most ? c[i] : most;
    }
    const uint32_t span = etch_wrap_sub((uint32_t)most, (uint32_t)least);
    const uint32_t middle = etch_wrap_add((uint32_t)least, (span >> 1) + (span & 1));
    const int8_t e = numerators(value, c, q, middle);
    const int32_t limit = e > 23 ? least_q >> (e - 23) : least_q;

    a->middle = middle;
    a->least = (int32_t)etch_wrap_sub((uint32_t)least, middle);
    a->most = (int32_t)etch_wrap_sub((uint32_t)most, middle);
    a->least_q12 = (a->least + 15) >> 4; /* least <= 0 */
    a->most_q12 = a->most >> 4;
    a->exponent = (int8_t)(e - 34);
    signed_plane(&a->numerator, t, basis, value);
    return span < UINT32_C(8192) << 16 &&
           rises_less(t, value, limit < INT32_C(1) << 25 ? limit : INT32_C(1) << 25);
}

bool etch_texture_perspective(struct etch_perspective_planes *p, const struct etch_triangle *t,
                              const struct etch_basis *basis,
                              const struct etch_texture_vertex *const vertex[3])
{
    const etch_q16 us[3] = {vertex[0]->u, vertex[1]->u, vertex[2]->u};
    const etch_q16 vs[3] = {vertex[0]->v, vertex[1]->v, vertex[2]->v};
    int32_t q[3];

    inverses(q, vertex);
    const int32_t lesser = q[0] < q[1] ? q[0] : q[1], least = lesser < q[2] ? lesser : q[2];
    const uint32_t inverse[3] = {(uint32_t)q[0], (uint32_t)q[1], (uint32_t)q[2]};
    const bool u = axis(&p->u, t, basis, us, q, least), v = axis(&p->v, t, basis, vs, q, least);
    /* 16 slopes are at most half the least */
    const bool blocks = u && v && rises_less(t, q, least >> 5);

    etch_texture_plane(&p->denominator, t, basis, inverse);
    p->least = blocks ? least >> 1 : least;
    return blocks;
}
