/* frame/accumulation_add.c: adds a frame to a sum. Called by applications, once for each drawing
 * of a strip. See accumulation.h. */
#include "accumulation_rows.h"

static void add(uint16_t *sums, const uint16_t *pixel, uint32_t weight)
{
    const uint32_t color = *pixel;

    sums[0] = accumulation_held(sums[0] + (color >> 11) * weight); /* 65535 + 63 * 65535 < 2^22 */
    sums[1] = accumulation_held(sums[1] + (color >> 5 & 63) * weight);
    sums[2] = accumulation_held(sums[2] + (color & 31) * weight);
}

void etch_accumulation_add(const struct etch_accumulation *a, const struct etch_surface *s,
                           uint16_t weight)
{
    accumulation_walk(a, s, weight, add);
}
