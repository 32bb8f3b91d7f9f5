/* raster/triangle_small.c: triangles to runs in few bytes. Called by draw/ with a paint.
 *
 * As in triangle.c, an edge from a down to b crosses the row of centres y_c = 256 y + 128 at
 *
 *      x_c = ax + (y_c - ay) dx / dy,   and its pixel is x = ceil((x_c - 128) / 256)
 *
 * and x and its excess e, in 1 / dy px rounded down, step by the whole and the rest of dx / dy.
 * Here one routine of products and quotients starts an edge on any row: the first one, a clip's
 * and the next block's are one case.
 *
 * Every row is crossed by two edges or none, and ceil never falls: the smaller x is the left
 * one. So nothing is sorted and no area is needed; without area both are equal.
 */
#include "triangle_small.h"

/* k n / d for k below 2^bits, n <= d <= 2^24, bit by bit from the top: the rest stays below 3 d. */
static uint32_t scale(uint32_t k, uint8_t bits, uint32_t n, uint32_t d, uint32_t *rest)
{
    uint32_t whole = 0, r = 0;

    k <<= 32 - bits;
    do {
        whole <<= 1;
        r <<= 1;
        if (k >> 31 != 0)
            r += n;
        k = etch_wrap_add(k, k);
        for (; r >= d; whole++)
            r -= d;
    } while (--bits != 0);
    *rest = r;
    return whole;
}

/* The first row whose centre is at or below y. */
static int32_t row_of(int32_t y_q8)
{
    return (y_q8 + 127) >> 8;
}

/* Up to 32 rows, to be filled in by their edges. */
struct block {
    int32_t y, y1;
    struct etch_run *run; /* of row y */
    const struct etch_rect *clip;
};

/* Widens the runs of the block to the edge from a down to b; none if b is not below a. All that
 * may pass 32 bits is modulo 2^32: the step of an edge that crosses one row is not used. */
static void edge(const struct block *block, const struct etch_point_q8 *a,
                 const struct etch_point_q8 *b)
{
    const int32_t top = row_of(a->y), bottom = row_of(b->y);
    const int32_t first = top > block->y ? top : block->y;
    int32_t n = (bottom < block->y1 ? bottom : block->y1) - first;

    if (n <= 0)
        return;

    const uint32_t dy = (uint32_t)(b->y - a->y), down = (uint32_t)(first * 256 + 128 - a->y);
    const int32_t dx = b->x - a->x, sign = dx >> 31;
    uint32_t rest = (uint32_t)(dx ^ sign), whole = 0, e;

    if (rest >= dy)
        whole = scale(rest, 25, 1, dy, &rest);
    whole ^= (uint32_t)sign; /* floor(dx / dy) = ~floor(~dx / dy) where dx < 0 */
    if (sign != 0)
        rest = dy - 1 - rest;
    /* x_c - 128 in 1/256 px is c + e / dy */
    uint32_t c = etch_wrap_add((uint32_t)(a->x - 128), etch_wrap_mul(down, whole));
    c = etch_wrap_add(c, scale(down, down < 256 ? 8 : 25, rest, dy, &e));
    const int32_t lo = block->clip->x0, hi = block->clip->x1;
    int32_t x = (int32_t)c >> 8, excess;

    e += (c & 255) * dy; /* below 256 dy <= 2^32 */
    excess = -(int32_t)((e >> 8) + ((e & 255) != 0));
    for (struct etch_run *run = block->run + (first - block->y);; run++) {
        if (excess < 0)
            excess += (int32_t)dy, x++;

        const int32_t seen = x < lo ? lo : x > hi ? hi : x;

        if (seen < run->x0)
            run->x0 = (int16_t)seen;
        if (seen > run->x1)
            run->x1 = (int16_t)seen;
        if (--n == 0)
            return;
        x += (int32_t)whole;
        excess -= (int32_t)rest;
    }
}

void etch_triangle_runs_small(const struct etch_surface *surface, const struct etch_point_q8 v[3],
                              const struct etch_paint *paint)
{
    const struct etch_rect *const clip = &surface->clip;
    struct etch_run runs[ETCH_RUN_BLOCK];
    struct block block = {clip->y1, 0, runs, clip};
    int32_t bottom = clip->y0;

    for (uint8_t i = 0; i < 3; i++) {
        const int32_t row = row_of(v[i].y);

        block.y = row < block.y ? row : block.y;
        bottom = row > bottom ? row : bottom;
    }
    block.y = block.y > clip->y0 ? block.y : clip->y0;
    bottom = bottom < clip->y1 ? bottom : clip->y1;
    for (; block.y < bottom; block.y = block.y1) {
        block.y1 = bottom;
        if (block.y1 > block.y + ETCH_RUN_BLOCK)
            block.y1 = block.y + ETCH_RUN_BLOCK;
        for (int32_t i = block.y1 - block.y; i-- != 0;)
            runs[i].x0 = clip->x1, runs[i].x1 = clip->x0;
        for (uint8_t i = 0; i < 3; i++) {
            const struct etch_point_q8 *const other = &v[i < 2 ? i + 1 : 0];

            edge(&block, &v[i], other);
            edge(&block, other, &v[i]);
        }
        paint->kernel(surface, (int16_t)block.y, runs, (uint8_t)(block.y1 - block.y), paint);
    }
}
