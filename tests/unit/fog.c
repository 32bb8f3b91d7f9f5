/* tests/unit: fog against its definition in 62-bit integers: every depth, many densities and
 * ranges. */
#include "core/fragment/fog.h"
#include "tests/harness/harness.h"

void suite_fog(void);

#define ONE (INT64_C(1) << 30)

static struct etch_chunk chunk;
static int64_t worst; /* 2^-30 */

/* exp(-x), x in 2^-30: the series of x / 1024, squared ten times. */
static int64_t exponential(int64_t x)
{
    int64_t term = ONE, sum = 0;
    int k;

    if (x > 40 * ONE)
        return 0;
    for (k = 1; k < 12; k++) {
        sum += (k & 1) != 0 ? term : -term;
        term = term * (x >> 10) / ONE / k;
    }
    for (k = 0; k < 10; k++)
        sum = sum * sum / ONE;
    return sum;
}

/* White fog over black: what a channel becomes is 1 - f, of which the chunk holds 16 bits. */
static void prepare(uint32_t z0, uint32_t step)
{
    uint16_t i;

    chunk.n = ETCH_CHUNK;
    for (i = 0; i < ETCH_CHUNK; i++) {
        chunk.r[i] = chunk.g[i] = chunk.b[i] = 0;
        chunk.z[i] = (uint16_t)(z0 + i * step < 65535 ? z0 + i * step : 65535);
    }
}

static void check(uint16_t i, int64_t f, int64_t bound)
{
    const int64_t got = (int64_t)chunk.g[i] * ONE / (INT64_C(63) << 10), off = got - (ONE - f);
    const int64_t size = off < 0 ? -off : off;

    worst = size > worst ? size : worst;
    if (size > bound + ONE / (INT64_C(63) << 10))
        CHECK_EQ(got, ONE - f);
}

static void linear_fog_keeps_its_bound(void)
{
    uint32_t seed = 5;
    int32_t k;
    uint16_t i;

    for (k = 0; k < TEST_COUNT(60) && !test_failed(); k++) {
        const int32_t start = k == 0 ? 0 : test_range(&seed, 0, 65534);
        const int32_t end = k == 0 ? 65535 : test_range(&seed, start + 1, 65535);
        struct etch_fog_linear fog;
        uint32_t z;

        CHECK_EQ(etch_fog_linear_init(&fog, (uint16_t)start, (uint16_t)end, 255, 255, 255), 0);
        for (z = 0; z < 65536; z += 16 * 7) {
            prepare(z, 7);
            etch_stage_fog_linear(&chunk, &fog);
            for (i = 0; i < ETCH_CHUNK; i++) {
                const int64_t f = (end - chunk.z[i]) * ONE / (end - start);

                check(i, f < 0 ? 0 : f > ONE ? ONE : f, ONE >> 14);
            }
        }
    }
}

static void exponential_fog_keeps_its_bound(void)
{
    static const int32_t densities[] = {0, 1, 65536, 3 * 65536, 9 * 65536, 700 * 65536, INT32_MAX};
    uint32_t seed = 6;
    int32_t k;
    uint16_t i;

    for (k = 0; k < TEST_COUNT(60) && !test_failed(); k++) {
        const int32_t density = k < 7 ? densities[k] : test_range(&seed, 0, 8 * 65536);
        struct etch_fog_exponential fog;
        uint32_t z;

        CHECK_EQ(etch_fog_exponential_init(&fog, density, 255, 255, 255), 0);
        for (z = 0; z < 65536; z += 16 * 7) {
            prepare(z, 7);
            etch_stage_fog_exponential(&chunk, &fog);
            for (i = 0; i < ETCH_CHUNK; i++)
                check(i, exponential((int64_t)density * chunk.z[i] * (ONE >> 16) / 65535),
                      ONE >> 13);
        }
    }
}

/* f = 1 leaves every colour, f = 0 makes every colour the fog's, bit for bit: also where the slope,
 * cut to 2^31 / 50000, does not reach 1. */
static void ends_are_exact(void)
{
    struct etch_fog_linear fog;
    uint32_t v;

    CHECK_EQ(etch_fog_linear_init(&fog, 100, 50100, 10, 20, 250), 0);
    chunk.n = 2;
    for (v = 0; v <= 64512; v++) {
        chunk.g[0] = chunk.g[1] = (uint16_t)v;
        chunk.r[0] = chunk.r[1] = chunk.b[0] = chunk.b[1] = (uint16_t)(v < 63488 ? v : 63488);
        chunk.z[0] = 100;
        chunk.z[1] = 50100;
        etch_stage_fog_linear(&chunk, &fog);
        if (chunk.g[0] != v || chunk.g[1] != fog.color[1] || chunk.r[1] != fog.color[0] ||
            chunk.b[1] != fog.color[2] || chunk.r[0] != (v < 63488 ? v : 63488))
            CHECK_EQ(chunk.g[0], v);
    }
}

static void wrong_fog_is_refused(void)
{
    struct etch_fog_linear linear = {{1, 2, 3}, 4, 5, 6};
    struct etch_fog_exponential exponential_ = {{1, 2, 3}, 4};

    CHECK_EQ(etch_fog_linear_init(&linear, 7, 7, 0, 0, 0), ETCH_EINVAL);
    CHECK_EQ(etch_fog_linear_init(&linear, 8, 7, 0, 0, 0), ETCH_EINVAL);
    CHECK_EQ(etch_fog_exponential_init(&exponential_, -1, 0, 0, 0), ETCH_EINVAL);
    CHECK(linear.color[0] == 1 && linear.slope == 6 && exponential_.rate == 4);
}

void suite_fog(void)
{
    worst = 0;
    RUN(linear_fog_keeps_its_bound);
    RUN(exponential_fog_keeps_its_bound);
    RUN(ends_are_exact);
    RUN(wrong_fog_is_refused);
    test_print_count("largest error of f ", worst >> 14, "/65536, allowed 9");
}
