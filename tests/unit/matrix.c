/* tests/unit: products of matrices and rotations against their definitions. */
#include "core/base/trig.h"
#include "core/vertex/matrix.h"
#include "tests/harness/harness.h"
#include "tests/oracle/wide.h"

void suite_matrix(void);

/* ---- products -------------------------------------------------------------------------------- */

static bool same(const struct etch_matrix *a, const struct etch_matrix *b)
{
    int i;

    for (i = 0; i < 16; i++)
        if (a->m[i / 4][i % 4] != b->m[i / 4][i % 4])
            return false;
    return true;
}

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

static void random_matrix(struct etch_matrix *m, uint32_t *seed)
{
    const int32_t down = test_range(seed, 0, 24);
    int i;

    for (i = 0; i < 16; i++)
        m->m[i / 4][i % 4] = (int32_t)test_random(seed) >> down;
}

/* Every entry is within half a unit of the exact sum, or that sum does not fit. */
static void products_are_rounded_once(void)
{
    uint32_t seed = 1;
    int32_t n, fits = 0;

    for (n = 0; n < TEST_COUNT(20000); n++) {
        struct etch_matrix a, b, product;
        bool out = false;
        int i, k;

        random_matrix(&a, &seed);
        random_matrix(&b, &seed);
        product = a;
        if (etch_matrix_multiply(&product, &product, &b) != ETCH_OK) {
            CHECK(same(&product, &a));
            for (i = 0; i < 16; i++) {
                struct signed_wide high = {{0, 0}, {0, 0}};

                for (k = 0; k < 4; k++)
                    add_product(&high, a.m[i / 4][k], b.m[k][i % 4]);
                out = out || !within(&high, (UINT64_C(1) << 47) - 32769);
            }
            CHECK(out);
            continue;
        }
        fits++;
        for (i = 0; i < 16; i++) {
            struct signed_wide error = {{0, 0}, {0, 0}};

            for (k = 0; k < 4; k++)
                add_product(&error, a.m[i / 4][k], b.m[k][i % 4]);
            add_product(&error, product.m[i / 4][i % 4], -65536);
            CHECK(within(&error, 32768));
        }
    }
    CHECK(fits > n / 4);
}

static void products_compose(void)
{
    struct etch_matrix move, turn, both, back, one;

    etch_matrix_translate(&move, 5 * 65536, 0, 0);
    etch_matrix_rotate_z(&turn, 0x4000);
    CHECK_EQ(etch_matrix_multiply(&both, &turn, &move), ETCH_OK);
    CHECK_EQ(both.m[0][3], 0); /* moved right, then turned: up */
    CHECK_EQ(both.m[1][3], 5 * 65536);
    etch_matrix_rotate_z(&back, 0xC000);
    CHECK_EQ(etch_matrix_multiply(&back, &back, &turn), ETCH_OK);
    etch_matrix_identity(&one);
    CHECK(same(&back, &one));
}

static int64_t distance(int64_t a, int64_t b)
{
    return a < b ? b - a : a - b;
}

/* ---- rotations ------------------------------------------------------------------------------- */

/* x to y, y to z, z to x: the same turn each, and about an axis of any length the same again. */
static void rotations_agree(void)
{
    static const struct etch_vector axes[] = {{7, 0, 0}, {0, INT32_MAX, 0}, {0, 0, 65536}};
    uint32_t angle;
    int axis, i;

    for (angle = 0; angle < 65536; angle += 97) {
        const etch_q16 s = etch_sin_q16((uint16_t)angle), c = etch_cos_q16((uint16_t)angle);
        struct etch_matrix r[3], about;

        etch_matrix_rotate_x(&r[0], (uint16_t)angle);
        etch_matrix_rotate_y(&r[1], (uint16_t)angle);
        etch_matrix_rotate_z(&r[2], (uint16_t)angle);
        for (axis = 0; axis < 3; axis++) {
            const int a = (axis + 1) % 3, b = (axis + 2) % 3;

            CHECK_EQ(r[axis].m[a][a], c);
            CHECK_EQ(r[axis].m[b][b], c);
            CHECK_EQ(r[axis].m[b][a], s);
            CHECK_EQ(r[axis].m[a][b], -s);
            CHECK_EQ(r[axis].m[axis][axis], 65536);
            CHECK_EQ(etch_matrix_rotate(&about, (uint16_t)angle, &axes[axis]), ETCH_OK);
            for (i = 0; i < 16; i++)
                CHECK(distance(about.m[i / 4][i % 4], r[axis].m[i / 4][i % 4]) <= 1);
        }
    }
}

/* A third of a turn about (1, 1, 1) takes x to y to z to x, and about (1, 2, 2) the axis stays. */
static void rotation_about_an_axis(void)
{
    static const struct etch_vector diagonal = {-3, -3, -3}, axis = {65536, 131072, 131072};
    static const struct etch_vector none = {0, 0, 0};
    struct etch_matrix m, before;
    uint32_t angle;
    int i, k;

    CHECK_EQ(etch_matrix_rotate(&m, 43691, &diagonal), ETCH_OK); /* -1/3 turn, minus the axis */
    for (i = 0; i < 3; i++)
        for (k = 0; k < 3; k++)
            CHECK(distance(m.m[i][k], (k + 1) % 3 == i ? 65536 : 0) <= 3); /* 1/3 is not exact */
    for (angle = 0; angle < 65536; angle += 111) {
        CHECK_EQ(etch_matrix_rotate(&m, (uint16_t)angle, &axis), ETCH_OK);
        for (i = 0; i < 3; i++) /* entries err by less than 1, times 1 + 2 + 2 */
            CHECK(distance(m.m[i][0] + 2 * m.m[i][1] + 2 * m.m[i][2], i == 0 ? 65536 : 131072) < 5);
    }
    before = m;
    CHECK_EQ(etch_matrix_rotate(&m, 1, &none), ETCH_EINVAL);
    CHECK(same(&m, &before));
}

void suite_matrix(void)
{
    RUN(products_are_rounded_once);
    RUN(products_compose);
    RUN(rotations_agree);
    RUN(rotation_about_an_axis);
}
