/* raster/curve_bits.c: how many chords a curve needs. Called by curve_quadratic.c and
 * curve_cubic.c. See curve.h. */
#include "curve.h"

uint8_t etch_curve_bits(uint32_t length_q8, int32_t flatness_q8)
{
    const uint32_t flat = flatness_q8 < 1 ? 1 : (uint32_t)flatness_q8;
    uint32_t far = length_q8 / 4 + (length_q8 % 4 != 0); /* of one chord, rounded up */
    uint8_t k = 0;

    for (; far > flat; k++)
        far = far / 4 + (far % 4 != 0);
    return k;
}
