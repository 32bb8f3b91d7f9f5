/* raster/texture_plane.c: the plane of a varying of any range. Called by texture_affine.c and
 * texture_perspective.c. See texture_plane.h, and basis.c for the derivation. */
#include "texture_plane.h"

/* N = n 2^down with |n| <= 2^31, for both products; |N| < 2^51. */
struct products {
    int32_t x, y;
    int8_t down;
};

static struct products products_of(const struct etch_basis *b, int32_t d1, int32_t d2)
{
    const int64_t x = etch_mul_s32(d1, b->y2) - etch_mul_s32(d2, b->y1);
    const int64_t y = etch_mul_s32(d2, b->x1) - etch_mul_s32(d1, b->x2);
    const uint64_t both = (uint64_t)(x < 0 ? -x : x) | (uint64_t)(y < 0 ? -y : y);
    const uint32_t high = (uint32_t)(both >> 31);
    struct products n = {0, 0, 0};

    if (high != 0) {
        n.down = (int8_t)(32 - etch_leading_zeros(high));
        n.x = (int32_t)(x >> n.down);
        n.y = (int32_t)(y >> n.down);
    } else if (both != 0) {
        const int8_t up = (int8_t)(etch_leading_zeros((uint32_t)both) - 1);

        n.down = (int8_t)-up;
        n.x = (int32_t)x * (INT32_C(1) << up);
        n.y = (int32_t)y * (INT32_C(1) << up);
    }
    return n;
}

/* slope f / 256 2^s, rounded; f = -127 .. 128, |slope| <= 2^30. */
static uint32_t offset(int32_t slope, int32_t f, int8_t s)
{
    return etch_wrap_scale((slope >> 8) * f + (((slope & 255) * f) >> 8), s);
}

/* Slopes 256 N / D = mul_high(n, reciprocal) 2^(8 + down + shift - 62 + 32). Above 2^28 units a
 * pixel what the high product drops would count: false. */
static bool near_plane(struct etch_plane *plane, const struct etch_basis *b, uint32_t v0,
                       int32_t d1, int32_t d2)
{
    const struct products n = products_of(b, d1, d2);
    int8_t s = (int8_t)(n.down + b->shift - 22);
    int32_t sx = etch_mul_high(n.x, b->reciprocal), sy = etch_mul_high(n.y, b->reciprocal);

    if (s > -2)
        return false;
    if (s < -31) /* slopes below 1/2 */
        s = -31, sx = 0, sy = 0;
    plane->dx = etch_wrap_scale(sx, s);
    plane->dy = etch_wrap_scale(sy, s);
    v0 = etch_wrap_add(v0, etch_wrap_add(offset(sx, b->fx, s), offset(sy, b->fy, s)));
    plane->origin = etch_wrap_sub(v0, etch_wrap_add(etch_wrap_mul(plane->dx, (uint32_t)b->ax),
                                                    etch_wrap_mul(plane->dy, (uint32_t)b->ay)));
    return true;
}

void etch_texture_plane(struct etch_plane *plane, const struct etch_triangle *t,
                        const struct etch_basis *basis, const uint32_t value[3])
{
    const uint32_t v0 = value[t->order[0]];
    const int32_t d1 = (int32_t)value[t->order[1]] - (int32_t)v0;
    const int32_t d2 = (int32_t)value[t->order[2]] - (int32_t)v0;

    if (basis == NULL || !near_plane(plane, basis, v0, d1, d2))
        etch_plane_setup(plane, t, value);
}
