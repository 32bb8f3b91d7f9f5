/* tests/unit: unit vectors, normals and lamps against exact integers. */
#include "core/vertex/lamp.h"
#include "core/base/unit.h"
#include "core/vertex/normal.h"
#include "tests/harness/harness.h"
#include "tests/oracle/wide.h"

void suite_lamp(void);

/* ---- unit vectors -----------------------------------------------------------------------------
 */

static uint64_t exact_root(uint64_t v)
{
    uint64_t root = 0;

    for (uint64_t bit = UINT64_C(1) << 31; bit != 0; bit >>= 1)
        if ((root | bit) * (root | bit) <= v)
            root |= bit;
    return root;
}

/* |r - 2^31 / sqrt(s)| < 3, that is (r - 3)^2 s < 2^62 < (r + 3)^2 s. */
static void reciprocal_roots_are_near(void)
{
    uint32_t seed = 1;

    for (int32_t n = 0; n < TEST_COUNT(100000) && !test_failed(); n++) {
        const uint32_t s = n < 1000   ? (UINT32_C(1) << 30) + (uint32_t)n
                           : n < 2000 ? UINT32_MAX - (uint32_t)(n - 1000)
                                      : test_random(&seed) | UINT32_C(1) << (n % 2 == 0 ? 31 : 30);
        const uint64_t r = etch_rsqrt_q31(s);
        const struct wide low = wide_product((r - 3) * (r - 3), s);
        const struct wide high = wide_product((r + 3) * (r + 3), s);

        if (!CHECK(low.hi == 0 && low.lo < UINT64_C(1) << 62) ||
            !CHECK(high.hi != 0 || high.lo > UINT64_C(1) << 62))
            test_note("s", s);
    }
}

/* Of any size, often with small and zero components. */
static int32_t random_component(uint32_t *seed)
{
    static const int32_t ends[] = {INT32_MIN, INT32_MAX, 0, 1, -1, 32767, -32768};

    return test_range(seed, 0, 7) == 0 ? ends[test_range(seed, 0, 6)]
                                       : (int32_t)test_random(seed) >> test_range(seed, 0, 31);
}

/* Every component within 2 units of v / |v|, by a root of 31 bits or more. */
static bool is_unit_of(const int16_t unit[3], const int64_t v[3])
{
    uint64_t most = 0, length;
    int64_t w[3] = {v[0], v[1], v[2]};

    for (int i = 0; i < 3; i++)
        most |= (uint64_t)(w[i] < 0 ? -w[i] : w[i]);
    for (; most < UINT64_C(1) << 29; most *= 2)
        w[0] *= 2, w[1] *= 2, w[2] *= 2;
    for (; most >= UINT64_C(1) << 31; most /= 2)
        w[0] /= 2, w[1] /= 2, w[2] /= 2;
    length = exact_root((uint64_t)(w[0] * w[0]) + (uint64_t)(w[1] * w[1]) +
                        (uint64_t)(w[2] * w[2]));
    for (int i = 0; i < 3; i++) {
        const int64_t error = unit[i] * (int64_t)length - w[i] * 16384;

        if (error > 2 * (int64_t)length + 32768 || error < -2 * (int64_t)length - 32768)
            return false;
    }
    return true;
}

static void units_are_near(void)
{
    uint32_t seed = 2;

    for (int32_t n = 0; n < TEST_COUNT(100000) && !test_failed(); n++) {
        const int32_t v[3] = {random_component(&seed), random_component(&seed),
                              random_component(&seed)};
        const int64_t wide[3] = {v[0], v[1], v[2]};
        int16_t unit[3] = {1, 1, 1};

        if ((v[0] | v[1] | v[2]) == 0) {
            CHECK(!etch_unit_q14(unit, v));
            CHECK(unit[0] == 0 && unit[1] == 0 && unit[2] == 0);
        } else {
            CHECK(etch_unit_q14(unit, v));
            if (!CHECK(is_unit_of(unit, wide)))
                test_note("n", n);
            CHECK(etch_dot_q28(unit, unit) > 16382 * 16382 &&
                  etch_dot_q28(unit, unit) < 16386 * 16386);
        }
    }
}

/* ---- normals ----------------------------------------------------------------------------------
 */

/* Entries of any size, or a scale that differs by axis and mirrors. */
static void random_matrix(struct etch_matrix *m, int kind, uint32_t *seed)
{
    etch_matrix_identity(m);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            m->m[i][j] = kind == 0   ? test_range(seed, -200000, 200000)
                         : kind == 1 ? (i == j ? test_range(seed, -200000, 200000) : 0)
                                     : random_component(seed) >> 2;
}

/* Entries are the exact cofactors, with the sign of the determinant, by a power of two. */
static void normal_matrices_are_cofactors(void)
{
    uint32_t seed = 3;
    int32_t checked = 0;

    for (int32_t n = 0; n < TEST_COUNT(50000) && !test_failed(); n++) {
        struct etch_matrix m;
        struct etch_normal_matrix normals;
        int64_t cofactor[3][3], determinant = 0;
        uint64_t most = 0;
        int down = 0;

        random_matrix(&m, n % 2, &seed);
        for (int i = 0; i < 3; i++) {
            const int a = (i + 1) % 3, b = (i + 2) % 3;

            for (int j = 0; j < 3; j++) {
                const int c = (j + 1) % 3, d = (j + 2) % 3;

                cofactor[i][j] = (int64_t)m.m[a][c] * m.m[b][d] - (int64_t)m.m[a][d] * m.m[b][c];
                most |= (uint64_t)(cofactor[i][j] < 0 ? -cofactor[i][j] : cofactor[i][j]);
            }
        }
        for (int j = 0; j < 3; j++)
            determinant += m.m[0][j] * cofactor[0][j];
        if (etch_normal_matrix_init(&normals, &m) != ETCH_OK) {
            CHECK(most == 0);
            continue;
        }
        while (most >> down >= 1 << 14)
            down++;
        if (most < 1 << 14)
            continue;
        checked++;
        for (int k = 0; k < 9; k++) {
            const int64_t sign = determinant < 0 ? -1 : 1;
            const int64_t error = normals.m[k / 3][k % 3] * (INT64_C(1) << down) -
                                  sign * cofactor[k / 3][k % 3];

            CHECK(error < INT64_C(1) << down && error > -(INT64_C(1) << down));
        }
    }
    CHECK(checked > TEST_COUNT(50000) / 2);
}

/* What is at right angles to the normal stays so, and the normal points to the same side. */
static void normals_stay_at_right_angles(void)
{
    uint32_t seed = 4;

    for (int32_t n = 0; n < TEST_COUNT(50000) && !test_failed(); n++) {
        struct etch_matrix m;
        struct etch_normal_matrix normals;
        const int8_t normal[3] = {(int8_t)test_range(&seed, -127, 127),
                                  (int8_t)test_range(&seed, -127, 127),
                                  (int8_t)test_range(&seed, -127, 127)};
        const int32_t tangent[3] = {normal[1], -normal[0], 0};
        int16_t unit[3];
        int64_t v[3] = {0, 0, 0}, dot = 0, side = 0, length = 0;

        random_matrix(&m, 1, &seed);
        for (int i = 0; i < 3; i++) /* scales of 1/4 .. 3 */
            m.m[i][i] += m.m[i][i] < 0 ? -16384 : 16384;
        CHECK_EQ(etch_normal_matrix_init(&normals, &m), ETCH_OK);
        etch_normal_transform(&normals, normal, unit);
        for (int i = 0; i < 3; i++) {
            int64_t to = 0, along = 0;

            for (int j = 0; j < 3; j++) {
                v[i] += normals.m[i][j] * normal[j];
                to += (int64_t)m.m[i][j] * tangent[j];
                along += (int64_t)m.m[i][j] * normal[j];
            }
            dot += unit[i] * to;
            length += (to < 0 ? -to : to);
            side += unit[i] * along;
        }
        if (normal[0] == 0 && normal[1] == 0 && normal[2] == 0) {
            CHECK(unit[0] == 0 && unit[1] == 0 && unit[2] == 0);
            continue;
        }
        CHECK(is_unit_of(unit, v));
        CHECK(side > 0);
        /* 2 units of rounding, and entries of 13 bits that differ by 13^2 at most */
        CHECK((dot < 0 ? -dot : dot) <= length * 400);
    }
}

static void flattened_models(void)
{
    struct etch_matrix m;
    struct etch_normal_matrix normals;
    static const int8_t up[3] = {3, 127, 5};
    int16_t unit[3];

    etch_matrix_scale(&m, 65536, 0, 65536); /* to the plane y = 0: normals are up or down */
    CHECK_EQ(etch_normal_matrix_init(&normals, &m), ETCH_OK);
    etch_normal_transform(&normals, up, unit);
    CHECK(unit[0] == 0 && unit[1] == 16384 && unit[2] == 0);
    etch_matrix_scale(&m, 65536, 0, 0);
    CHECK_EQ(etch_normal_matrix_init(&normals, &m), ETCH_EINVAL);
}

void suite_lamp(void)
{
    RUN(reciprocal_roots_are_near);
    RUN(units_are_near);
    RUN(normal_matrices_are_cofactors);
    RUN(normals_stay_at_right_angles);
    RUN(flattened_models);
}
