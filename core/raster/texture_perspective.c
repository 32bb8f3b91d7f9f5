/* raster/texture_perspective.c: texture coordinates in perspective. Called by draw/. See
 * texture_plane.h.
 *
 * What is linear on the screen is 1/w and u/w. Scaled so that the greatest 1/w is q = 2^29 .. 2^30,
 * and u taken against the middle of the vertices, |u| <= 2^31,
 *
 *      denominator = q,   numerator = u q / 2^e,   |u| < 2^(e - 1), so that |numerator| < 2^29,
 *
 * the coordinate is middle + numerator / denominator 2^e. Errors of q are relative to each vertex
 * and as small as those of the reciprocal; errors of the planes weigh R = greatest w / least w
 * times as much at the farthest vertex as at the nearest.
 */
#include "texture_plane.h"
#include "texture_values.h"

/* True if 256 |n| / D < limit; n = |v1 y2 - v2 y1| is the slope along a row, |v| < 2^31, and below
 * 2^56. limit <= 2^25. */
static bool rises_less(const struct etch_triangle *t, const uint32_t value[3], int32_t limit)
{
    const int32_t v0 = (int32_t)value[t->order[0]];
    const int64_t n = etch_mul_s32((int32_t)value[t->order[1]] - v0, t->p[2].y - t->p[0].y) -
                      etch_mul_s32((int32_t)value[t->order[2]] - v0, t->p[1].y - t->p[0].y);

    return (uint64_t)(n < 0 ? -n : n) >> 2 < (t->area >> 2) * (uint32_t)(limit >> 8);
}

/* One coordinate. True if blocks are possible: it spans less than 8192 texels and changes by less
 * than 4096 in 16 pixels even where 1/w is half its least, as
 *      16 slope 2^e / (least / 2) < 2^28  <=>  slope < least 2^(23 - e). */
static bool axis(struct etch_perspective_axis *a, const struct etch_triangle *t,
                 const struct etch_basis *basis, const etch_q16 c[3], const int32_t q[3],
                 int32_t least_q)
{
    uint32_t value[3];
    const int8_t e = etch_texture_numerators(a, value, c, q);
    const int32_t limit = e > 23 ? least_q >> (e - 23) : least_q;

    a->least_q12 = (a->least + 15) >> 4; /* least <= 0 */
    a->most_q12 = a->most >> 4;
    etch_texture_plane(&a->numerator, t, basis, value);
    a->numerator.origin = etch_wrap_sub(a->numerator.origin, UINT32_C(1) << 29);
    return etch_wrap_sub((uint32_t)a->most, (uint32_t)a->least) < UINT32_C(8192) << 16 &&
           rises_less(t, value, limit < INT32_C(1) << 25 ? limit : INT32_C(1) << 25);
}

bool etch_texture_perspective(struct etch_perspective_planes *p, const struct etch_triangle *t,
                              const struct etch_basis *basis,
                              const struct etch_texture_vertex *const vertex[3])
{
    const etch_q16 us[3] = {vertex[0]->u, vertex[1]->u, vertex[2]->u};
    const etch_q16 vs[3] = {vertex[0]->v, vertex[1]->v, vertex[2]->v};
    int32_t q[3];

    const int32_t least = etch_texture_inverses(q, vertex);
    const uint32_t inverse[3] = {(uint32_t)q[0], (uint32_t)q[1], (uint32_t)q[2]};
    const bool u = axis(&p->u, t, basis, us, q, least), v = axis(&p->v, t, basis, vs, q, least);
    /* 16 slopes are at most half the least */
    const bool blocks = u && v && rises_less(t, inverse, least >> 5);

    etch_texture_plane(&p->denominator, t, basis, inverse);
    p->least = blocks ? least >> 1 : least;
    p->blocks = blocks;
    return blocks;
}
