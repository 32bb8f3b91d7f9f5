/* fragment/opacity.c: alpha times one alpha for all. A stage; see source_map.h. */
#include "source_map.h"

/* n / 255 = n1 + (n1 + n0) / 255 with n = 256 n1 + n0; m = n1 + n0 <= 65535, and then m / 255 is
 * (m + 1 + m / 256) / 256, rounded down. */
static uint16_t scaled(uint32_t a, uint32_t opacity)
{
    const uint32_t n = a * opacity + 127, n1 = n >> 8, m = n1 + (n & 255);

    return (uint16_t)(n1 + ((m + 1 + (m >> 8)) >> 8));
}

void etch_stage_opacity(struct etch_chunk *c, const void *data)
{
    const uint8_t opacity = ((const struct etch_blend_constant *)data)->alpha;

    for (uint16_t i = 0; i < c->n; i++)
        c->a[i] = scaled(c->a[i], opacity);
}
