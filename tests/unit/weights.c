/* tests/unit: the weights of a triangle's vertices in perspective keep their own bound (weights.h)
 * against their definition, for triangles and distances of every size. */
#include "core/fragment/weights.h"
#include "core/raster/weights.h"
#include "tests/harness/harness.h"

void suite_weights(void);

static double edge_over_w(const struct etch_point_q8 p[3], int i, double x, double y, double w)
{
    const struct etch_point_q8 a = p[(i + 1) % 3], b = p[(i + 2) % 3];
    const double e = ((double)b.x - a.x) * (y - (double)a.y) -
                     ((double)b.y - a.y) * (x - (double)a.x);

    return e / w;
}

/* Whether the weights at the pixel's centre are within 2^-25 and 2^-29 more for cutting to 2^29;
 * edges are below 2^50, so that a double has them. */
static bool within(const struct etch_weights *weights, const struct etch_point_q8 p[3],
                   const uint32_t w[3], int16_t x, int16_t y)
{
    const struct etch_weight_pair pair = etch_weights_at(weights, x, y);
    const double got[2] = {pair.one / 536870912.0, pair.two / 536870912.0};
    double term[3], sum = 0;
    int i;

    for (i = 0; i < 3; i++) {
        term[i] = edge_over_w(p, i, x * 256.0 + 128, y * 256.0 + 128, w[i]);
        sum += term[i];
    }
    for (i = 0; i < 2; i++) {
        const double off = got[i] - term[weights->order[i + 1]] / sum;

        if (off > 17.0 / 536870912.0 || off < -17.0 / 536870912.0)
            return false;
    }
    return true;
}

static bool is_inside(const struct etch_point_q8 p[3], int16_t x, int16_t y, double side)
{
    int i;

    for (i = 0; i < 3; i++)
        if (edge_over_w(p, i, x * 256.0 + 128, y * 256.0 + 128, side) < 0)
            return false;
    return true;
}

static void weights_keep_their_bound(void)
{
    uint32_t seed = 77;
    int round, inside = 0, bad = 0;

    for (round = 0; round < TEST_COUNT(40000); round++) {
        const int32_t reach = (int32_t)1 << test_range(&seed, 9, 23);
        struct etch_point_q8 p[3];
        struct etch_triangle t;
        struct etch_weights weights;
        uint32_t w[3];
        int i;

        for (i = 0; i < 3; i++) {
            p[i].x = test_range(&seed, -reach, reach);
            p[i].y = test_range(&seed, -reach, reach);
            w[i] = 1 + (test_random(&seed) >> test_range(&seed, 0, 31)) / 2;
        }
        if (!etch_triangle_setup(&t, p))
            continue;
        etch_weights_setup(&weights, &t, w);
        for (i = 0; i < 8; i++) {
            const int16_t x = (int16_t)(test_range(&seed, -reach, reach - 1) >> 8);
            const int16_t y = (int16_t)(test_range(&seed, -reach, reach - 1) >> 8);

            if (is_inside(p, x, y, t.winding)) {
                inside++;
                bad += !within(&weights, p, w, x, y);
            }
        }
    }
    CHECK(inside > TEST_COUNT(8000));
    CHECK_EQ(bad, 0);
}

void suite_weights(void)
{
    RUN(weights_keep_their_bound);
}
