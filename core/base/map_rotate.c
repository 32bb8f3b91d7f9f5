/* base/map_rotate.c: an image turned and scaled about a point. Called by applications. See map.h.
 */
#include "map_parts.h"
#include "trig.h"

#define LEAST_SCALE 8 /* 2^48 / 8 = 2^45 */

/* round(c 2^18 / scale): c in 2.30, the result has 32 fraction bits. */
static int64_t step(int32_t c_q30, etch_q16 scale)
{
    const bool below = (c_q30 < 0) != (scale < 0);
    const uint64_t n = (uint64_t)(c_q30 < 0 ? -(int64_t)c_q30 : c_q30) << 18;
    const uint64_t d = (uint64_t)(scale < 0 ? -(int64_t)scale : scale);
    const int64_t q = (int64_t)etch_divide_u64(n + d / 2, d).quotient;

    return below ? -q : q;
}

static bool is_small(etch_q16 scale)
{
    return scale < LEAST_SCALE && scale > -LEAST_SCALE;
}

static etch_q16 part(etch_q16 scale, int32_t c_q30)
{
    return etch_saturate_s32(etch_mul_s32(scale, c_q30) >> 30);
}

/* Where `from` comes to lie, for the bounds: a texel's pixel errs by up to 1/2 for 2^15 texels. */
static struct etch_rect reach(struct etch_rect from, const struct etch_map_place *p, int32_t c,
                              int32_t s)
{
    const struct etch_affine a = {.xu = part(p->scale_u, c),
                                  .xv = part(p->scale_v, -s),
                                  .yu = part(p->scale_u, s),
                                  .yv = part(p->scale_v, c)};

    return etch_map_bounds(
        from, &a, p->x - (etch_mul_s32(a.xu, p->u) >> 16) - (etch_mul_s32(a.xv, p->v) >> 16),
        p->y - (etch_mul_s32(a.yu, p->u) >> 16) - (etch_mul_s32(a.yv, p->v) >> 16));
}

enum etch_status etch_map_rotate(struct etch_map *map, struct etch_rect from,
                                 const struct etch_map_place *p)
{
    const int32_t c = etch_cos_q30(p->angle), s = etch_sin_q30(p->angle);

    if (is_small(p->scale_u) || is_small(p->scale_v) || etch_rect_is_empty(from)) {
        etch_map_nothing(map);
        return ETCH_EINVAL;
    }
    *map = (struct etch_map){
        .ux = step(c, p->scale_u),
        .uy = step(s, p->scale_u),
        .vx = -step(s, p->scale_v),
        .vy = step(c, p->scale_v),
        .from = from,
        .bounds = reach(from, p, c, s),
    };
    map->u = (int64_t)p->u * 65536 - etch_map_along(map->ux, p->x) - etch_map_along(map->uy, p->y);
    map->v = (int64_t)p->v * 65536 - etch_map_along(map->vx, p->x) - etch_map_along(map->vy, p->y);
    return ETCH_OK;
}
