/* leaf/vector128/edge_run.c: etch_edge_run in 32.32, in place of raster/edge_run.c. Called by
 * triangle.c for triangles inside the clip.
 *
 * In row k the edge crosses at X + k dx / dy, in pixels, and the run begins at the ceiling of that,
 * a multiple of 1 / (256 dy). With the slope rounded down to 2^-32 the position in 2^-32 is at most
 * n + 2 units too small, and with one unit less than a pixel added it rounds down to the ceiling as
 * long as n + 3 <= 2^24 / dy. Edges for which this does not hold go the portable way.
 */
#include "../../raster/edge.h"

static ETCH_COLD int16_t *portable(struct etch_point_q8 a, struct etch_point_q8 b, int16_t *out,
                                   int32_t n)
{
    struct edge g;

    edge_start(&g, a, b, false);
    return edge_walk(&g, out, n);
}

int16_t *etch_edge_run(struct etch_point_q8 a, struct etch_point_q8 b, int16_t *out, int32_t n)
{
    const int64_t dx = b.x - a.x, dy = b.y - a.y, k = (128 - a.y) & 255;
    int16_t *const end = out + 2 * (ptrdiff_t)n;

    ETCH_ASSERT(n <= ETCH_RUN_BLOCK);
    if (dy >= INT32_C(1) << 18 || (dx < 0 ? -dx : dx) >= INT32_C(1) << 22)
        return portable(a, b, out, n);
    /* of a quotient rounded towards 0, at most one unit too large: so one less if it is negative */
    const int64_t slope = dx * (INT64_C(1) << 32) / dy - (dx < 0 ? 1 : 0);
    int64_t x = ((int64_t)a.x - 128) * (INT32_C(1) << 24) + (k * slope >> 8) + UINT32_MAX;

    if ((n & 1) != 0) {
        *out = (int16_t)(x >> 32);
        out += 2;
        x += slope;
    }
    for (; out != end; out += 4) {
        out[0] = (int16_t)(x >> 32);
        x += slope;
        ETCH_KEEP(x);
        out[2] = (int16_t)(x >> 32);
        x += slope;
    }
    return out;
}
