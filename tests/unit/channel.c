/* tests/unit: the formats that channels and depths take in planes, against their definition. */
#include "core/raster/basis.h"
#include "core/raster/plane.h"
#include "tests/harness/harness.h"
#include "tests/harness/shapes.h"

void suite_channel(void);

/* round(c * steps * 2^bits / 255), which has no ties, and 1/2. */
static uint64_t exact(uint64_t c, uint64_t steps, int bits)
{
    const uint64_t twice = 2 * c * steps << bits;

    return (twice + 255) / 510 + (UINT64_C(1) << (bits - 1));
}

static void all_channels_are_nearest(void)
{
    uint32_t c;

    for (c = 0; c <= 255; c++) {
        CHECK_EQ(etch_channel_q27((uint8_t)c), exact(c, 31, 27));
        CHECK_EQ(etch_channel_q26((uint8_t)c), exact(c, 63, 26));
    }
}

#define FAR UINT32_C(0xFFFF0000) /* 65535.0 */

static const uint32_t beyond[] = {FAR,          FAR + 1,      FAR + 0x7FFF, FAR + 0x8000,
                                  FAR + 0x8001, FAR + 0xFFFE, UINT32_MAX};

static void depths_beyond_far_are_far(void)
{
    size_t i;

    CHECK_EQ(etch_depth_q16(0), 0x8000);
    CHECK_EQ(etch_depth_q16(FAR - 1), UINT32_C(0xFFFF7FFF));
    for (i = 0; i < sizeof beyond / sizeof beyond[0]; i++)
        CHECK_EQ(etch_depth_q16(beyond[i]), UINT32_C(0xFFFF8000));
}

/* The planes of near triangles by their reciprocal, where there is one; returns if there is. */
static bool basis_depth(const struct etch_triangle *t, const struct etch_vertex *const v[3],
                        struct etch_plane *z)
{
    struct etch_basis b;

    return etch_basis_setup(&b, t) && etch_basis_depth(&b, t, v, z);
}

static bool same(const struct etch_plane *a, const struct etch_plane *b)
{
    return a->origin == b->origin && a->dx == b->dx && a->dy == b->dy;
}

/* Both ways to a depth plane take them so too: whatever the triangle, its plane is that of the
 * clamped depths. */
static void planes_take_depths_beyond_far_as_far(void)
{
    const struct etch_rect window = {0, 0, 40, 30};
    uint32_t seed = 48;
    int32_t i, near = 0, exact_ones = 0;

    for (i = 0; i < TEST_COUNT(20000) && !test_failed(); i++) {
        struct etch_vertex given[3] = {{0, 0, 0, 0, 0, 0, 0}}, clamped[3] = {{0, 0, 0, 0, 0, 0, 0}};
        const struct etch_vertex *const g[3] = {&given[0], &given[1], &given[2]};
        const struct etch_vertex *const c[3] = {&clamped[0], &clamped[1], &clamped[2]};
        struct etch_plane a = {0, 0, 0}, b = {0, 0, 0};
        struct etch_point_q8 p[3];
        struct test_triangle shape;
        struct etch_triangle t;
        bool is_near;
        int k;

        test_triangle_make(&shape, (enum test_triangle_kind)(i % TEST_TRIANGLE_KINDS), window,
                           &seed);
        for (k = 0; k < 3; k++) {
            const uint32_t z = test_random(&seed);

            p[k].x = shape.x[k];
            p[k].y = shape.y[k];
            given[k].z_q16 = z % 3 == 0 ? z : beyond[z / 3 % 7];
            clamped[k].z_q16 = given[k].z_q16 > FAR ? FAR : given[k].z_q16;
        }
        if (!etch_triangle_setup(&t, p))
            continue;
        etch_plane_depth(&t, g, &a);
        etch_plane_depth(&t, c, &b);
        CHECK(same(&a, &b));
        exact_ones++;
        is_near = basis_depth(&t, g, &a);
        CHECK_EQ(is_near, basis_depth(&t, c, &b));
        CHECK(!is_near || same(&a, &b));
        near += is_near;
    }
    CHECK(near > exact_ones / 4 && near < exact_ones);
}

void suite_channel(void)
{
    RUN(all_channels_are_nearest);
    RUN(depths_beyond_far_are_far);
    RUN(planes_take_depths_beyond_far_as_far);
}
