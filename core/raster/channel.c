/* raster/channel.c: 8-bit channels to the formats of colour planes. Called once per vertex and
 * channel, before etch_plane_setup. See plane.h.
 *
 *      31 * 2^27 / 255 = 16316665 - 7 / 255        63 * 2^26 / 255 = 16579837 - 1 / 85
 *
 * The small fraction times c, rounded to nearest, is (7 c + 127) / 255 and (c + 42) / 85; the
 * divisions are products with a rounded-up reciprocal, right for all 256 values (tested). */
#include "plane.h"

uint32_t etch_channel_q27(uint8_t c)
{
    const uint32_t excess = ((UINT32_C(7) * c + 128) * 257) >> 16;

    return UINT32_C(16316665) * c - excess + (UINT32_C(1) << 26);
}

uint32_t etch_channel_q26(uint8_t c)
{
    const uint32_t excess = ((UINT32_C(1) * c + 42) * 772) >> 16;

    return UINT32_C(16579837) * c - excess + (UINT32_C(1) << 25);
}
