/* frame/accumulation_load.c: begins a sum of frames. Called by applications, once a strip. See
 * accumulation.h. */
#include "accumulation_rows.h"

static void load(uint16_t *sums, const uint16_t *pixel, uint32_t weight)
{
    const uint32_t color = *pixel;

    sums[0] = accumulation_held((color >> 11) * weight);
    sums[1] = accumulation_held((color >> 5 & 63) * weight);
    sums[2] = accumulation_held((color & 31) * weight);
}

void etch_accumulation_load(const struct etch_accumulation *a, const struct etch_surface *s,
                            uint16_t weight)
{
    accumulation_walk(a, s, weight, load);
}
