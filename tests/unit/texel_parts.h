/* tests/unit: images of all formats for the suites of textures in whole pipelines. */
#ifndef TESTS_UNIT_TEXEL_PARTS_H
#define TESTS_UNIT_TEXEL_PARTS_H

#include "core/fragment/sampler.h"
#include "tests/harness/harness.h"

enum {
    TEXELS = 2048,
    TEXEL_FORMATS = 4
};

struct texels {
    uint16_t colors[TEXELS], palette[256];
    uint8_t bytes[TEXELS], alpha[TEXELS];
};

static inline void texels_fill(struct texels *t, uint32_t *seed)
{
    for (int i = 0; i < TEXELS; i++) {
        t->colors[i] = (uint16_t)(test_random(seed) & 0xFFFF);
        t->bytes[i] = (uint8_t)(test_random(seed) & 0xFF);
        t->alpha[i] = (uint8_t)(test_random(seed) & 0xFF);
    }
    for (int i = 0; i < 256; i++)
        t->palette[i] = (uint16_t)(test_random(seed) & 0xFFFF);
}

/* RGB565, the same with a mask, 8 bits with alpha, 4 bits; without a size. */
static inline struct etch_image texels_image(const struct texels *t, int format)
{
    const struct etch_image images[TEXEL_FORMATS] = {
        {etch_texels_rgb565, NULL, t->colors, NULL, NULL, 0, 0, 0},
        {etch_texels_rgb565, etch_texels_mask, t->colors, NULL, t->alpha, 0, 0, 0},
        {etch_texels_index8, etch_texels_alpha8, t->bytes, t->palette, t->alpha, 0, 0, 0},
        {etch_texels_index4, NULL, t->bytes, t->palette, NULL, 0, 0, 0}};

    return images[format];
}

#endif
