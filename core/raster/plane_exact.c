/* raster/plane_exact.c: numerators of interpolated values. Called by draw/ for the exact modes,
 * once per varying of a visible triangle. See plane_exact.h; the slopes are those of plane.c before
 * their division by D, times 256 for a step of a pixel. All is modulo 2^64. */
#include "plane_exact.h"

/* a * b - c * d */
static uint64_t cross_wrap(int64_t a, int32_t b, int64_t c, int32_t d)
{
    return (uint64_t)a * (uint64_t)(int64_t)b - (uint64_t)c * (uint64_t)(int64_t)d;
}

void etch_exact_plane_setup(struct etch_exact_plane *plane, const struct etch_triangle *t,
                            const uint32_t value[3])
{
    const uint32_t v0 = value[t->order[0]];
    const int64_t v1 = (int64_t)value[t->order[1]] - v0;
    const int64_t v2 = (int64_t)value[t->order[2]] - v0;
    const int32_t x1 = t->p[1].x - t->p[0].x, y1 = t->p[1].y - t->p[0].y;
    const int32_t x2 = t->p[2].x - t->p[0].x, y2 = t->p[2].y - t->p[0].y;
    const uint64_t side = (uint64_t)(int64_t)t->side;
    const uint64_t nx = etch_wrap_mul_u64(cross_wrap(v1, y2, v2, y1), side);
    const uint64_t ny = etch_wrap_mul_u64(cross_wrap(v2, x1, v1, x2), side);
    const uint64_t ox = etch_wrap_mul_u64(nx, (uint64_t)(int64_t)(128 - t->p[0].x));
    const uint64_t oy = etch_wrap_mul_u64(ny, (uint64_t)(int64_t)(128 - t->p[0].y));

    plane->origin = etch_wrap_add_u64(etch_wrap_mul_u64(t->area, v0), etch_wrap_add_u64(ox, oy));
    plane->dx = etch_wrap_mul_u64(nx, 256);
    plane->dy = etch_wrap_mul_u64(ny, 256);
}
