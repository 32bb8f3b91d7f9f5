/* fragment/fog_linear.c: fog that grows linearly with depth. A stage; see fog.h. */
#include "fog_mix.h"

enum etch_status etch_fog_linear_init(struct etch_fog_linear *fog, uint16_t start, uint16_t end,
                                      uint8_t r, uint8_t g, uint8_t b)
{
    if (start >= end)
        return ETCH_EINVAL;
    etch_fog_color(fog->color, r, g, b);
    fog->start = start;
    fog->end = end;
    fog->slope = (UINT32_C(1) << 31) / (uint32_t)(end - start);
    return ETCH_OK;
}

/* (end - z) slope <= 2^31 between start and end, and errs by less than 2^16. */
void etch_stage_fog_linear(struct etch_chunk *c, const void *data)
{
    const struct etch_fog_linear *const fog = (const struct etch_fog_linear *)data;

    for (uint16_t i = 0; i < c->n; i++) {
        const uint16_t z = c->z[i];
        const uint32_t f = z <= fog->start ? 32768
                           : z >= fog->end ? 0
                                           : ((uint32_t)(fog->end - z) * fog->slope + 0x8000) >> 16;

        etch_fog_mix(c, i, fog->color, f);
    }
}
