/* fragment/mipmap.c: the level of a triangle. Called by applications for each triangle, before
 * drawing. See mipmap.h. */
#include "mipmap.h"

/* |a x b|, the area of the parallelogram; differences below 2^25 give less than 2^51. */
static uint64_t area_of(int32_t ax, int32_t ay, int32_t bx, int32_t by)
{
    const int64_t area = etch_mul_s32(ax, by) - etch_mul_s32(ay, bx);

    return (uint64_t)(area < 0 ? -area : area);
}

/* Both areas are twice those of the triangle, in (1/256)^2. 4^k P <= 2 T holds for an integer P iff
 * it holds with 2 T / 4^k rounded down. */
uint8_t etch_mipmap_level(const struct etch_mipmap *m, const struct etch_texture_vertex *const v[3])
{
    const int32_t u = v[0]->u >> 8, t = v[0]->v >> 8, x = v[0]->at.x_q8, y = v[0]->at.y_q8;
    const uint64_t pixels = area_of(v[1]->at.x_q8 - x, v[1]->at.y_q8 - y, v[2]->at.x_q8 - x,
                                    v[2]->at.y_q8 - y);
    uint64_t texels = area_of((v[1]->u >> 8) - u, (v[1]->v >> 8) - t, (v[2]->u >> 8) - u,
                              (v[2]->v >> 8) - t) *
                      2;
    uint8_t level = 0;

    while (level + 1 < m->count && texels >> 2 >= pixels) {
        texels >>= 2;
        level++;
    }
    return level;
}
