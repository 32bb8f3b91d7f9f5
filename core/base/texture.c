/* base/texture.c: checks what a texture is made of. Called by applications. See texture.h. */
#include "texture.h"

/* log2 of a power of two, 16 for anything else. */
static uint8_t power_of(uint16_t side)
{
    uint8_t bits = 0;

    while (bits < 16 && side != UINT32_C(1) << bits)
        bits++;
    return bits;
}

enum etch_status etch_texture_init(struct etch_texture *t, const uint16_t *texels, uint16_t width,
                                   uint16_t height)
{
    const uint8_t width_bits = power_of(width), height_bits = power_of(height);

    if (texels == NULL || width_bits > 12 || height_bits > 15 || width_bits + height_bits > 16)
        return ETCH_EINVAL;
    t->texels = texels;
    t->width_bits = width_bits;
    t->height_bits = height_bits;
    return ETCH_OK;
}
