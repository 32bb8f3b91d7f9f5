/* tests/unit: the sine of every angle, and projections by angle, against Taylor's series. */
#include "core/base/trig.h"
#include "core/vertex/matrix.h"
#include "tests/harness/harness.h"
#include "tests/oracle/wide.h"

void suite_matrix_angle(void);

#define PI_Q60 INT64_C(0x3243F6A8885A308D)

/* a * b of 4.60 numbers, truncated. */
static uint64_t mul_q60(uint64_t a, uint64_t b)
{
    const struct wide p = wide_product(a, b);

    return (p.hi & ((UINT64_C(1) << 60) - 1)) << 4 | p.lo >> 60;
}

/* Taylor's series over the first quarter turn, the rest by symmetry; good to 2^-54. */
static int64_t exact_sine_q60(uint32_t angle)
{
    const uint32_t folded = (angle & 0x4000) != 0 ? 0x8000 - (angle & 0x7FFF) : angle & 0x3FFF;
    const uint64_t x = (uint64_t)PI_Q60 / 32768 * folded;
    const uint64_t square = mul_q60(x, x);
    uint64_t term = x;
    int64_t sum = (int64_t)x;
    uint32_t k;

    for (k = 2; k < 30; k += 2) {
        term = mul_q60(term, square) / (k * (k + 1));
        sum += k % 4 == 2 ? -(int64_t)term : (int64_t)term;
    }
    return (angle & 0x8000) != 0 ? -sum : sum;
}

static int64_t distance(int64_t a, int64_t b)
{
    return a < b ? b - a : a - b;
}

static void sine_of_every_angle(void)
{
    uint32_t a;

    for (a = 0; a < 65536; a++) {
        const uint16_t angle = (uint16_t)a;
        const int64_t exact = exact_sine_q60(a);

        CHECK(distance(etch_sin_q30(angle) * (INT64_C(1) << 30), exact) < INT64_C(2) << 30);
        CHECK(distance(etch_sin_q16(angle) * (INT64_C(1) << 44), exact) <=
              (INT64_C(1) << 43) + (INT64_C(1) << 31));
        CHECK_EQ(etch_cos_q30(angle), etch_sin_q30((uint16_t)(a + 0x4000)));
        CHECK_EQ(etch_sin_q30((uint16_t)(0x18000 - a)), etch_sin_q30(angle));
        CHECK_EQ(etch_sin_q30((uint16_t)(0x20000 - a)), -etch_sin_q30(angle));
    }
    CHECK_EQ(etch_sin_q16(0), 0);
    CHECK_EQ(etch_sin_q30(0x4000), INT32_C(1) << 30);
    CHECK_EQ(etch_sin_q16(0x4000), 65536);
    CHECK_EQ(etch_cos_q16(0x4000), 0);
    CHECK_EQ(etch_cos_q16(0x8000), -65536);
}

/* cot(fov / 2) = (1 + cos) / sin, from the exact sines. */
static void perspective_by_angle(void)
{
    struct etch_matrix m;
    uint32_t fov;

    for (fov = 1; fov < 0x8000; fov += fov < 200 ? 1 : 37) {
        const int64_t sine = exact_sine_q60(fov) >> 30;
        const int64_t cosine = exact_sine_q60(fov + 0x4000) >> 30;
        const int64_t one = INT64_C(1) << 30;

        CHECK_EQ(etch_matrix_perspective(&m, (uint16_t)fov, 65536, 65536, 131072), ETCH_OK);
        CHECK_EQ(m.m[0][0], m.m[1][1]);
        if (fov > 0x4000) /* sin / (1 - cos) */
            CHECK(distance(sine * 65536, (one - cosine) * m.m[1][1]) <= one - cosine);
        else
            CHECK(distance((one + cosine) * 65536, sine * m.m[1][1]) <= sine + (one + cosine) * 2);
    }
    CHECK_EQ(etch_matrix_perspective(&m, 0x4000, 65536, 65536, 131072), ETCH_OK);
    CHECK_EQ(m.m[1][1], 65536);
    CHECK_EQ(etch_matrix_perspective(&m, 0, 65536, 65536, 131072), ETCH_EINVAL);
    CHECK_EQ(etch_matrix_perspective(&m, 0x8000, 65536, 65536, 131072), ETCH_EINVAL);
    CHECK_EQ(etch_matrix_perspective(&m, 0x8001, 65536, 65536, 131072), ETCH_EINVAL);
    CHECK_EQ(etch_matrix_perspective(&m, 0x2000, 0, 65536, 131072), ETCH_EINVAL);
    CHECK_EQ(etch_matrix_perspective(&m, 0x2000, 65536, 65536, 65536), ETCH_EINVAL);
    CHECK_EQ(etch_matrix_perspective(&m, 0x2000, 65536, 65536, 65537), ETCH_ERANGE);
}

void suite_matrix_angle(void)
{
    RUN(sine_of_every_angle);
    RUN(perspective_by_angle);
}
