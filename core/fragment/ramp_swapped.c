/* fragment/ramp_swapped.c: the colours between stops for surfaces in rgb565_swapped. Called by
 * applications. See gradient.h. */
#include "ramp.h"

enum etch_status etch_ramp_init_swapped(struct etch_ramp *ramp, uint16_t *color, uint8_t bits,
                                        const struct etch_stop *stop, uint8_t count)
{
    return etch_ramp_fill(ramp, color, bits, stop, count, true);
}
