/* tests/unit: the arithmetic of base/fixed.h and base/rgb565.h against plain definitions. */
#include "core/base/fixed.h"
#include "core/base/rgb565.h"
#include "tests/harness/harness.h"

void suite_fixed(void);

static void snap_is_round_half_up(void)
{
    static const int32_t ends[] = {INT32_MIN, -32768 * 256, -1, 0, 1, INT32_MAX};
    uint32_t seed = 1;
    int32_t i;

    for (i = -70000; i <= 70000; i++)
        CHECK_EQ(etch_snap_q8(i), ((int64_t)i + 128) >> 8);
    for (i = 0; i < 6; i++)
        CHECK_EQ(etch_snap_q8(ends[i]), ((int64_t)ends[i] + 128) >> 8);
    CHECK_EQ(etch_snap_q8(INT32_MAX), INT32_C(1) << 23);
    CHECK_EQ(etch_snap_q8(INT32_MIN), -(INT32_C(1) << 23));
    for (i = 0; i < TEST_COUNT(100000); i++) {
        const int32_t v = (int32_t)test_random(&seed);

        CHECK_EQ(etch_snap_q8(v), ((int64_t)v + 128) >> 8);
    }
}

void suite_fixed(void)
{
    RUN(snap_is_round_half_up);
}
