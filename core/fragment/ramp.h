/* fragment/ramp.h: the colours of a gradient; no part of the API. */
#ifndef ETCH_FRAGMENT_RAMP_H
#define ETCH_FRAGMENT_RAMP_H

#include "../base/rgb565.h"
#include "gradient.h"

/* The colour at `at`, between the last stop at or before it and the next. */
uint16_t etch_ramp_color(const struct etch_stop *stop, uint8_t count, uint32_t at);

bool etch_ramp_valid(uint8_t bits, const struct etch_stop *stop, uint8_t count);

ETCH_INLINE enum etch_status etch_ramp_fill(struct etch_ramp *ramp, uint16_t *color, uint8_t bits,
                                            const struct etch_stop *stop, uint8_t count,
                                            bool swapped)
{
    if (!etch_ramp_valid(bits, stop, count))
        return ETCH_EINVAL;
    for (uint32_t i = 0; i < UINT32_C(1) << bits; i++) {
        const uint16_t c = etch_ramp_color(stop, count, (2 * i + 1) << (15 - bits));

        color[i] = swapped ? etch_rgb565_swap(c) : c;
    }
    ramp->color = color;
    ramp->bits = bits;
    return ETCH_OK;
}

#endif
