/* fragment/dither_bayer.c: thresholds for ordered dithering. Read by the dithered kernels. See
 * dither.h. */
#include "dither.h"

/* Of the pixels of four neighbours (0 2 / 3 1) come first, then of four such groups, then of four
 * of those; times 2, plus 1. */
const uint8_t etch_dither_bayer[8][8] = {
    {1, 65, 17, 81, 5, 69, 21, 85},   {97, 33, 113, 49, 101, 37, 117, 53},
    {25, 89, 9, 73, 29, 93, 13, 77},  {121, 57, 105, 41, 125, 61, 109, 45},
    {7, 71, 23, 87, 3, 67, 19, 83},   {103, 39, 119, 55, 99, 35, 115, 51},
    {31, 95, 15, 79, 27, 91, 11, 75}, {127, 63, 111, 47, 123, 59, 107, 43},
};
