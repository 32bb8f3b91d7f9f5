/* tests/harness: the kernel that checks runs in bands. Called by the suites. See bands.h. */
#include "bands.h"

struct test_run_paint test_band_paint(struct test_run_log *log, uint16_t color)
{
    struct test_run_paint p = test_run_paint(log, color);

    p.paint.kernel = test_kernel_bands;
    return p;
}

void test_kernel_bands(const struct etch_surface *s, int16_t y0, const struct etch_run *runs,
                       uint8_t n, const struct etch_paint *paint)
{
    struct test_run_log *const log = ((const struct test_run_paint *)paint)->log;

    if (y0 < log->next_row) /* above the top of the block before */
        log->broken = true;
    log->next_row = INT32_MIN;
    test_kernel_checked(s, y0, runs, n, paint);
    log->next_row = y0;
}

struct test_run_paint test_tile_paint(struct test_run_log *log, uint16_t color)
{
    struct test_run_paint p = test_run_paint(log, color);

    p.paint.kernel = test_kernel_tiles;
    return p;
}

void test_kernel_tiles(const struct etch_surface *s, int16_t y0, const struct etch_run *runs,
                       uint8_t n, const struct etch_paint *paint)
{
    ((const struct test_run_paint *)paint)->log->next_row = INT32_MIN;
    test_kernel_checked(s, y0, runs, n, paint);
}
