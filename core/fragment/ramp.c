/* fragment/ramp.c: the colours between stops. Called by applications. See gradient.h. */
#include "ramp.h"

bool etch_ramp_valid(uint8_t bits, const struct etch_stop *stop, uint8_t count)
{
    if (bits < 1 || bits > 8 || count == 0)
        return false;
    for (uint8_t i = 1; i < count; i++)
        if (stop[i].at < stop[i - 1].at)
            return false;
    return true;
}

/* round(most (a (w - k) + b k) / (255 w)), ties upwards: below 2 * 63 * 255 * 2^16 < 2^31. */
static uint16_t channel(uint8_t a, uint8_t b, uint32_t k, uint32_t w, uint32_t most)
{
    return (uint16_t)((2 * most * (a * (w - k) + b * k) + 255 * w) / (2 * 255 * w));
}

uint16_t etch_ramp_color(const struct etch_stop *stop, uint8_t count, uint32_t at)
{
    uint8_t i = 0;
    uint32_t k = 0, w = 1; /* before the first and after the last stop: all of `from` */

    while (i + 1 < count && stop[i + 1].at <= at)
        i++;
    const struct etch_stop *const from = &stop[i];
    const struct etch_stop *const to = i + 1 < count ? from + 1 : from;

    if (to != from && at > from->at) {
        k = at - from->at;
        w = (uint32_t)to->at - from->at;
    }
    return (uint16_t)((uint32_t)channel(from->r, to->r, k, w, 31) << 11 |
                      (uint32_t)channel(from->g, to->g, k, w, 63) << 5 |
                      channel(from->b, to->b, k, w, 31));
}

enum etch_status etch_ramp_init(struct etch_ramp *ramp, uint16_t *color, uint8_t bits,
                                const struct etch_stop *stop, uint8_t count)
{
    return etch_ramp_fill(ramp, color, bits, stop, count, false);
}
