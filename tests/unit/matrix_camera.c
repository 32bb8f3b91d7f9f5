/* tests/unit: the camera and the projections against exact quotients and roots. */
#include "core/vertex/matrix.h"
#include "tests/harness/harness.h"
#include "tests/oracle/wide.h"

void suite_matrix_camera(void);

static bool same(const struct etch_matrix *a, const struct etch_matrix *b)
{
    int i;

    for (i = 0; i < 16; i++)
        if (a->m[i / 4][i % 4] != b->m[i / 4][i % 4])
            return false;
    return true;
}

/* ---- the eye --------------------------------------------------------------------------------- */

struct vector64 {
    int64_t v[3];
};

static struct vector64 cross(const struct vector64 *a, const struct vector64 *b)
{
    struct vector64 c;
    int i;

    for (i = 0; i < 3; i++)
        c.v[i] = a->v[(i + 1) % 3] * b->v[(i + 2) % 3] - a->v[(i + 2) % 3] * b->v[(i + 1) % 3];
    return c;
}

/* entry = v[i] / |v| to less than one unit, by squares: (|entry| - 1)^2 |v|^2 < v[i]^2 2^32 <
 * (|entry| + 1)^2 |v|^2, where the lower bound is void below 1. */
static bool is_unit(etch_q16 entry, const struct vector64 *v, int i)
{
    const uint64_t size = (uint64_t)(entry < 0 ? -entry : entry);
    struct wide squares = {0, 0};
    uint64_t part[3];
    int k;

    for (k = 0; k < 3; k++) {
        part[k] = (uint64_t)(v->v[k] < 0 ? -v->v[k] : v->v[k]);
        squares = wide_sum(squares, wide_product(part[k], part[k]));
    }
    const struct wide exact = wide_scale(wide_scale(wide_product(part[i], part[i]), 65536), 65536);
    const struct wide above = wide_scale(wide_scale(squares, (uint32_t)size + 1),
                                         (uint32_t)size + 1);
    const struct wide below = size == 0 ? squares
                                        : wide_scale(wide_scale(squares, (uint32_t)size - 1),
                                                     (uint32_t)size - 1);

    return wide_at_most(exact, above) && (size == 0 || wide_at_most(below, exact)) &&
           (size <= 1 || (entry < 0) == (v->v[i] < 0));
}

static void look_at_rows_are_unit_vectors(void)
{
    uint32_t seed = 1;
    int32_t n, checked = 0;

    for (n = 0; n < TEST_COUNT(20000); n++) {
        int32_t c[9];
        struct etch_matrix m;
        int i, row;

        for (i = 0; i < 9; i++)
            c[i] = test_range(&seed, -4095, 4095) * (n % 3 == 0 ? 1 : 5000);
        const struct etch_vector eye = {c[0], c[1], c[2]}, target = {c[3], c[4], c[5]};
        const struct etch_vector up = {c[6], c[7], c[8]};
        const int32_t unit = n % 3 == 0 ? 1 : 5000;
        const struct vector64 view = {
            {(c[3] - c[0]) / unit, (c[4] - c[1]) / unit, (c[5] - c[2]) / unit}};
        const struct vector64 above = {{c[6] / unit, c[7] / unit, c[8] / unit}};
        const struct vector64 right = cross(&view, &above);
        const struct vector64 upward = cross(&right, &view);
        const struct vector64 back = {{-view.v[0], -view.v[1], -view.v[2]}};
        const struct vector64 *const rows[3] = {&right, &upward, &back};

        if (etch_matrix_look_at(&m, &eye, &target, &up) != ETCH_OK) {
            CHECK(right.v[0] == 0 && right.v[1] == 0 && right.v[2] == 0);
            continue;
        }
        checked++;
        for (row = 0; row < 3; row++) {
            const int64_t moved = (int64_t)m.m[row][0] * c[0] + (int64_t)m.m[row][1] * c[1] +
                                  (int64_t)m.m[row][2] * c[2];

            for (i = 0; i < 3; i++)
                CHECK(is_unit(m.m[row][i], rows[row], i));
            CHECK_EQ(m.m[row][3], (-moved + 32768) >> 16);
            CHECK_EQ(m.m[3][row], 0);
        }
        CHECK_EQ(m.m[3][3], 65536);
    }
    CHECK(checked > n - 10);
}

/* An up vector 2^-20 of a radian beside the view is enough, and one exactly on it refused. */
static void look_at_needs_little(void)
{
    static const struct etch_vector eye = {0, 0, 0}, target = {0, 0, -(INT32_C(1) << 24)};
    struct etch_vector up = {0, 0, INT32_C(1) << 24};
    struct etch_matrix m, one;

    CHECK_EQ(etch_matrix_look_at(&m, &eye, &target, &up), ETCH_EINVAL);
    up.y = 16;
    CHECK_EQ(etch_matrix_look_at(&m, &eye, &target, &up), ETCH_OK);
    etch_matrix_identity(&one);
    CHECK(same(&m, &one));
}

static void look_at_refuses(void)
{
    static const struct etch_vector zero = {0, 0, 0}, ahead = {0, 0, -65536};
    static const struct etch_vector back = {0, 0, 7}, up = {0, 65536, 0};
    static const struct etch_vector far = {INT32_MAX, INT32_MAX, 0}, low = {-65536, -65536, 0};
    struct etch_matrix m, before, one;

    etch_matrix_rotate_x(&m, 1234);
    before = m;
    CHECK_EQ(etch_matrix_look_at(&m, &ahead, &ahead, &up), ETCH_EINVAL);
    CHECK_EQ(etch_matrix_look_at(&m, &zero, &ahead, &zero), ETCH_EINVAL);
    CHECK_EQ(etch_matrix_look_at(&m, &zero, &ahead, &back), ETCH_EINVAL);
    CHECK_EQ(etch_matrix_look_at(&m, &far, &low, &ahead), ETCH_ERANGE);
    CHECK(same(&m, &before));
    CHECK_EQ(etch_matrix_look_at(&m, &zero, &ahead, &up), ETCH_OK);
    etch_matrix_identity(&one);
    CHECK(same(&m, &one));
}

/* ---- projections ----------------------------------------------------------------------------- */

/* A positive and a negative wide part, apart. */
struct signed_wide {
    struct wide plus, minus;
};

static void add_product(struct signed_wide *s, int64_t a, int64_t b)
{
    const struct wide p = wide_product(a < 0 ? (uint64_t)-a : (uint64_t)a,
                                       b < 0 ? (uint64_t)-b : (uint64_t)b);

    if ((a < 0) != (b < 0))
        s->minus = wide_sum(s->minus, p);
    else
        s->plus = wide_sum(s->plus, p);
}

/* |s| <= n */
static bool within(const struct signed_wide *s, uint64_t n)
{
    const struct wide most = {0, n};

    return wide_at_most(wide_distance(s->plus, s->minus), most);
}

/* entry = n / d to half a unit; |n|, |d| < 2^63. */
static bool is_quotient(etch_q16 entry, int64_t n, int64_t d)
{
    struct signed_wide twice_error = {{0, 0}, {0, 0}};

    add_product(&twice_error, n, 2);
    add_product(&twice_error, d, -2 * (int64_t)entry);
    return within(&twice_error, (uint64_t)(d < 0 ? -d : d));
}

static etch_q16 random_size(uint32_t *seed)
{
    return (int32_t)(test_random(seed) >> test_range(seed, 1, 28)) + 1 -
           (test_range(seed, 0, 30) == 0 ? 5 : 0);
}

static void perspective_is_rounded(void)
{
    uint32_t seed = 1;
    int32_t n, good = 0, large = 0;

    for (n = 0; n < TEST_COUNT(50000); n++) {
        const etch_q16 focal = random_size(&seed), aspect = random_size(&seed);
        const etch_q16 near = random_size(&seed), far = random_size(&seed);
        struct etch_matrix m, before;
        enum etch_status status;

        etch_matrix_identity(&m);
        before = m;
        status = etch_matrix_perspective_focal(&m, focal, aspect, near, far);
        if (focal <= 0 || aspect <= 0 || near <= 0 || far <= near) {
            CHECK_EQ(status, ETCH_EINVAL);
            CHECK(same(&m, &before));
        } else if (status == ETCH_OK) {
            good++;
            CHECK(is_quotient(m.m[0][0], (int64_t)focal * 65536, aspect));
            CHECK_EQ(m.m[1][1], focal);
            CHECK(is_quotient(m.m[2][2], ((int64_t)far + near) * 65536, (int64_t)near - far));
            CHECK(is_quotient(m.m[2][3], (int64_t)far * near * 2, (int64_t)near - far));
            CHECK_EQ(m.m[3][2], -65536);
            CHECK_EQ(m.m[3][3], 0);
        } else {
            const int64_t most = INT64_C(32768) * 65536 - 1;

            large++;
            CHECK_EQ(status, ETCH_ERANGE);
            CHECK(same(&m, &before));
            CHECK((int64_t)focal * 65536 / aspect >= most ||
                  ((int64_t)far + near) * 65536 / ((int64_t)far - near) >= most ||
                  (int64_t)far * near * 2 / ((int64_t)far - near) >= most);
        }
    }
    CHECK(good > n / 20);
    CHECK(large > TEST_COUNT(100));
}

static void boxes_are_rounded(void)
{
    uint32_t seed = 1;
    int32_t n, good = 0;

    for (n = 0; n < TEST_COUNT(50000); n++) {
        const struct etch_box b = {random_size(&seed) - 9, random_size(&seed) - 7,
                                   -random_size(&seed),    random_size(&seed),
                                   random_size(&seed),     random_size(&seed)};
        const int64_t width = (int64_t)b.right - b.left, height = (int64_t)b.top - b.bottom;
        const int64_t depth = (int64_t)b.far - b.near;
        struct etch_matrix f, o;
        const enum etch_status frustum = etch_matrix_frustum(&f, &b);
        const enum etch_status parallel = etch_matrix_orthographic(&o, &b);
        const bool valid = width != 0 && height != 0 && depth > 0;

        CHECK_EQ(parallel == ETCH_EINVAL, !valid);
        CHECK_EQ(frustum == ETCH_EINVAL, !valid || b.near <= 0);
        if (frustum == ETCH_OK) {
            good++;
            CHECK(is_quotient(f.m[0][0], (int64_t)b.near * 131072, width));
            CHECK(is_quotient(f.m[0][2], ((int64_t)b.right + b.left) * 65536, width));
            CHECK(is_quotient(f.m[1][1], (int64_t)b.near * 131072, height));
            CHECK(is_quotient(f.m[1][2], ((int64_t)b.top + b.bottom) * 65536, height));
            CHECK(is_quotient(f.m[2][2], ((int64_t)b.far + b.near) * -65536, depth));
            CHECK(is_quotient(f.m[2][3], (int64_t)b.far * b.near * -2, depth));
            CHECK_EQ(f.m[3][2], -65536);
            CHECK_EQ(f.m[3][3], 0);
        }
        if (parallel == ETCH_OK) {
            good++;
            CHECK(is_quotient(o.m[0][0], INT64_C(2) << 32, width));
            CHECK(is_quotient(o.m[0][3], ((int64_t)b.right + b.left) * -65536, width));
            CHECK(is_quotient(o.m[1][1], INT64_C(2) << 32, height));
            CHECK(is_quotient(o.m[1][3], ((int64_t)b.top + b.bottom) * -65536, height));
            CHECK(is_quotient(o.m[2][2], -(INT64_C(2) << 32), depth));
            CHECK(is_quotient(o.m[2][3], ((int64_t)b.far + b.near) * -65536, depth));
            CHECK_EQ(o.m[3][3], 65536);
        }
    }
    CHECK(good > n / 20);
}

void suite_matrix_camera(void)
{
    RUN(look_at_rows_are_unit_vectors);
    RUN(look_at_needs_little);
    RUN(look_at_refuses);
    RUN(perspective_is_rounded);
    RUN(boxes_are_rounded);
}
