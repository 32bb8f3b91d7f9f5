/* tests/harness/bands.h: a checked kernel for shapes that hand over runs in bands of rows: as
 * test_kernel_checked (canvas.h), but a block may begin again at the top of the one before. */
#ifndef TESTS_HARNESS_BANDS_H
#define TESTS_HARNESS_BANDS_H

#include "canvas.h"

/* A paint with a fresh log, whose kernel is test_kernel_bands. */
struct test_run_paint test_band_paint(struct test_run_log *log, uint16_t color);
etch_kernel test_kernel_bands;

/* The same for shapes that are handed over in tiles: the order is not looked at. */
struct test_run_paint test_tile_paint(struct test_run_log *log, uint16_t color);
etch_kernel test_kernel_tiles;

#endif
