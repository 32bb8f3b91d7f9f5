/* tests/unit: the arithmetic of base/fixed.h and base/rgb565.h against plain definitions. */
#include "core/base/fixed.h"
#include "core/base/rgb565.h"
#include "tests/harness/harness.h"
#include "tests/oracle/wide.h"

void suite_fixed(void);

static const int32_t ends[] = {
    INT32_MIN, INT32_MIN + 1, -65537, -65536, -65535, -32769, -32768,        -2,       -1, 0, 1,
    2,         32767,         32768,  65535,  65536,  65537,  INT32_MAX - 1, INT32_MAX};
#define ENDS (int)(sizeof ends / sizeof ends[0])

static int32_t saturated(int64_t v)
{
    return v > INT32_MAX ? INT32_MAX : v < INT32_MIN ? INT32_MIN : (int32_t)v;
}

/* floor(a / b + 1/2) for b > 0, with the C operators. */
static int64_t round_half_up(int64_t a, int64_t b)
{
    const int64_t q = a / b, r = a % b;
    const int64_t floor = r < 0 ? q - 1 : q;
    const int64_t rest = r < 0 ? r + b : r;

    return floor + (rest >= b - rest ? 1 : 0);
}

static void snap_is_round_half_up(void)
{
    uint32_t seed = 1;
    int32_t i;

    for (i = -70000; i <= 70000; i++)
        CHECK_EQ(etch_snap_q8(i), ((int64_t)i + 128) >> 8);
    for (i = 0; i < ENDS; i++)
        CHECK_EQ(etch_snap_q8(ends[i]), ((int64_t)ends[i] + 128) >> 8);
    CHECK_EQ(etch_snap_q8(INT32_MAX), INT32_C(1) << 23);
    CHECK_EQ(etch_snap_q8(INT32_MIN), -(INT32_C(1) << 23));
    for (i = 0; i < TEST_COUNT(100000); i++) {
        const int32_t v = (int32_t)test_random(&seed);

        CHECK_EQ(etch_snap_q8(v), ((int64_t)v + 128) >> 8);
    }
}

/* Products do not overflow a narrow int. */
static void products_are_exact(void)
{
    CHECK_EQ(etch_mul_s16(INT16_MIN, INT16_MIN), INT64_C(1) << 30);
    CHECK_EQ(etch_mul_s16(INT16_MIN, INT16_MAX), INT64_C(-32768) * 32767);
    CHECK_EQ(etch_mul_u16(UINT16_MAX, UINT16_MAX), INT64_C(65535) * 65535);
    CHECK_EQ(etch_mul_s32(INT32_MIN, INT32_MIN) == INT64_C(1) << 62, 1);
    CHECK_EQ(etch_mul_s32(INT32_MIN, INT32_MAX), INT64_C(-2147483648) * INT64_C(2147483647));
    CHECK_EQ(etch_wrap_add(UINT32_MAX, 2), 1);
    CHECK_EQ(etch_wrap_sub(1, 2), UINT32_MAX);
    CHECK_EQ(etch_wrap_mul(UINT32_C(0x80000001), 2), 2);
}

/* The upper half of a * b from the product of the magnitudes, rounded down. */
static int64_t high_half(int32_t a, int32_t b)
{
    const uint64_t product = wide_product((uint64_t)(a < 0 ? -(int64_t)a : a), (uint64_t)b).lo;
    const int64_t high = (int64_t)(product >> 32);

    return a >= 0 ? high : -high - ((product & UINT32_MAX) != 0 ? 1 : 0);
}

static void check_high(int32_t a, int32_t b)
{
    CHECK_EQ(etch_mul_high_wide(a, b), high_half(a, b));
    CHECK_EQ(etch_mul_high_split(a, b), high_half(a, b));
    CHECK_EQ(etch_mul_high(a, b), high_half(a, b));
}

/* Both forms, whichever this core takes. */
static void upper_halves_of_products_round_down(void)
{
    static const int32_t factors[] = {0,          1,          2,          32767,         32768,
                                      65535,      65536,      65537,      1 << 30,       0x40000001,
                                      0x4000FFFF, 0x7FFF0000, 0x7FFF0001, INT32_MAX - 1, INT32_MAX};
    uint32_t seed = 7;
    int32_t i;
    size_t j;

    for (j = 0; j < sizeof factors / sizeof factors[0]; j++) {
        for (i = 0; i < ENDS; i++)
            check_high(ends[i], factors[j]);
        for (i = 0; i < TEST_COUNT(20000); i++)
            check_high((int32_t)test_random(&seed) >> i % 31, factors[j]);
    }
    for (i = 0; i < TEST_COUNT(100000); i++) { /* reciprocals, 2^30 .. 2^31 - 1, and any other b */
        const int32_t b = (int32_t)(test_random(&seed) >> 1);

        check_high(ends[i % ENDS], b | 1 << 30);
        check_high((int32_t)test_random(&seed), b | 1 << 30);
        check_high((int32_t)test_random(&seed), b >> i % 31);
    }
}

static void check_q16(int32_t a, int32_t b)
{
    CHECK_EQ(etch_q16_mul(a, b), saturated(round_half_up((int64_t)a * b, 65536)));
    if (b != 0) {
        const int64_t n = b < 0 ? -(int64_t)a * 65536 : (int64_t)a * 65536;

        CHECK_EQ(etch_q16_div(a, b), saturated(round_half_up(n, b < 0 ? -(int64_t)b : b)));
    }
}

static void q16_products_and_quotients_round_half_up(void)
{
    uint32_t seed = 2;
    int32_t i, j;

    for (i = 0; i < ENDS; i++)
        for (j = 0; j < ENDS; j++)
            check_q16(ends[i], ends[j]);
    for (i = 0; i < TEST_COUNT(100000); i++) {
        const int32_t a = (int32_t)test_random(&seed), b = (int32_t)test_random(&seed);

        check_q16(a >> i % 31, b >> i % 29);
    }
    CHECK_EQ(etch_q16_div(1, 0), INT32_MAX);
    CHECK_EQ(etch_q16_div(-1, 0), INT32_MIN);
    CHECK_EQ(etch_q16_div(0, 0), 0);
}

/* n = quotient * d + remainder, remainder < d. */
static void check_divide(uint64_t n, uint64_t d)
{
    const struct etch_quotient r = etch_divide_u64(n, d);
    struct wide product = wide_product(r.quotient, d);
    const struct wide rest = {0, r.remainder};

    product = wide_sum(product, rest);
    CHECK(r.remainder < d);
    CHECK(product.hi == 0 && product.lo == n);
}

static void divide_u64_is_exact(void)
{
    const uint64_t top = UINT64_C(1) << 63;
    uint32_t seed = 3;
    int32_t i;

    check_divide(0, 1);
    check_divide(UINT64_MAX, 1);
    check_divide(UINT64_MAX, top);
    check_divide(UINT64_MAX, top - 1);
    check_divide(top, top);
    check_divide(top - 1, top);
    check_divide(UINT64_MAX, 3);
    for (i = 0; i < TEST_COUNT(100000); i++) {
        const uint64_t n = (uint64_t)test_random(&seed) << 32 | test_random(&seed);
        const uint64_t d = ((uint64_t)test_random(&seed) << 32 | test_random(&seed)) >>
                           test_range(&seed, 1, 63);

        check_divide(n >> test_range(&seed, 0, 63), d == 0 ? 1 : d);
    }
}

static void divide_round_s64_rounds_half_up(void)
{
    uint32_t seed = 4;
    int32_t i, j;

    for (i = -40; i <= 40; i++) {
        for (j = 1; j <= 12; j++) {
            CHECK_EQ(etch_divide_round_s64(i, j), round_half_up(i, j));
            CHECK_EQ(etch_divide_round_s64(i, -j), round_half_up(-i, j));
        }
    }
    for (i = 0; i < TEST_COUNT(100000); i++) {
        const int shift = test_range(&seed, 0, 61);
        const int64_t n = (int64_t)((uint64_t)test_random(&seed) << 31 | test_random(&seed) >> 1);
        const int64_t d = (1 + (int64_t)test_random(&seed)) >> test_range(&seed, 0, 30);

        if (d != 0) {
            CHECK_EQ(etch_divide_round_s64(n >> shift, d), saturated(round_half_up(n >> shift, d)));
            CHECK_EQ(etch_divide_round_s64(-(n >> shift), d),
                     saturated(round_half_up(-(n >> shift), d)));
        }
    }
    CHECK_EQ(etch_divide_round_s64(INT64_MAX, 1), INT32_MAX);
    CHECK_EQ(etch_divide_round_s64(-INT64_MAX, 1), INT32_MIN);
    CHECK_EQ(etch_divide_round_s64(-INT64_MAX, INT64_MAX), -1);
    CHECK_EQ(etch_divide_round_s64(INT64_C(2147483647), 1), INT32_MAX);
    CHECK_EQ(etch_divide_round_s64(INT64_C(-2147483648), 1), INT32_MIN);
    CHECK_EQ(etch_divide_round_s64(INT64_C(-4294967297), 2), INT32_MIN); /* a tie at the end */
}

static void sqrt_is_the_floor(void)
{
    uint32_t seed = 5, i;

    for (i = 0; i < 65536; i++) {
        const uint32_t square = i * i;

        CHECK_EQ(etch_sqrt_u32(square), i);
        if (i > 0)
            CHECK_EQ(etch_sqrt_u32(square - 1), i - 1);
    }
    CHECK_EQ(etch_sqrt_u32(UINT32_MAX), 65535);
    for (i = 0; i < (uint32_t)TEST_COUNT(100000); i++) {
        const uint32_t v = test_random(&seed);
        const uint64_t root = etch_sqrt_u32(v);

        CHECK(root * root <= v && (root + 1) * (root + 1) > v);
    }
}

/* All 2^8 values of each channel to RGB565, all 2^16 colours to bytes and back. */
static void rgb565_is_nearest_and_replicates(void)
{
    uint32_t v;

    for (v = 0; v < 256; v++) {
        const uint8_t c = (uint8_t)v;

        CHECK_EQ(etch_rgb565(c, 0, 0), round_half_up(v * 31, 255) << 11);
        CHECK_EQ(etch_rgb565(0, c, 0), round_half_up(v * 63, 255) << 5);
        CHECK_EQ(etch_rgb565(0, 0, c), round_half_up(v * 31, 255));
    }
    for (v = 0; v < 65536; v++) {
        const uint16_t c = (uint16_t)v;
        const uint32_t r = v >> 11, g = v >> 5 & 63, b = v & 31;

        CHECK_EQ(etch_rgb565_red(c), r << 3 | r >> 2);
        CHECK_EQ(etch_rgb565_green(c), g << 2 | g >> 4);
        CHECK_EQ(etch_rgb565_blue(c), b << 3 | b >> 2);
        CHECK_EQ(etch_rgb565(etch_rgb565_red(c), etch_rgb565_green(c), etch_rgb565_blue(c)), c);
        CHECK_EQ(etch_rgb565_swap(c), (v & 255) << 8 | v >> 8);
    }
}

void suite_fixed(void)
{
    RUN(snap_is_round_half_up);
    RUN(products_are_exact);
    RUN(upper_halves_of_products_round_down);
    RUN(q16_products_and_quotients_round_half_up);
    RUN(divide_u64_is_exact);
    RUN(divide_round_s64_rounds_half_up);
    RUN(sqrt_is_the_floor);
    RUN(rgb565_is_nearest_and_replicates);
}
