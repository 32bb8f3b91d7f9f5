/* tests/oracle/sampler.h: textures by their definition, in exact rationals. Slow and plain; nothing
 * here is shared with core. */
#ifndef TESTS_ORACLE_SAMPLER_H
#define TESTS_ORACLE_SAMPLER_H

#include <stdint.h>

enum oracle_wrap {
    ORACLE_REPEAT,
    ORACLE_CLAMP,
    ORACLE_MIRROR
};

/* Channels r, g, b, a of texel (x, y), 0 .. 31, 63, 31, 255. */
typedef void oracle_texel(int32_t x, int32_t y, uint8_t channel[4]);

struct oracle_sampler {
    oracle_texel *texel;
    int32_t width, height;
    enum oracle_wrap wrap_u, wrap_v;
};

/* Where the whole coordinate k lands, one period after the other. */
int32_t oracle_wrapped(enum oracle_wrap wrap, int32_t k, int32_t size);

/* The texel that holds the point, 16.16. */
void oracle_nearest(const struct oracle_sampler *s, int32_t u, int32_t v, uint8_t channel[4]);

/* The weighted mean of the four texels round it, times 2^32, exactly, and the greatest difference
 * between two of them. */
void oracle_linear(const struct oracle_sampler *s, int32_t u, int32_t v, uint64_t mean_q32[4],
                   uint8_t spread[4]);

#endif
