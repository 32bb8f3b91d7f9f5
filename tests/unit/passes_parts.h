/* tests/unit: what the suites of passes over frames share: a small frame, its channels, random
 * colours and parts of it. */
#ifndef TESTS_UNIT_PASSES_PARTS_H
#define TESTS_UNIT_PASSES_PARTS_H

#include "core/base/surface.h"
#include "core/frame/jitter.h"
#include "tests/harness/harness.h"

enum {
    WIDTH = 32,
    HEIGHT = 24,
    PIXELS = WIDTH * HEIGHT,
    LARGE = 4
};

static const struct etch_rect frame = {0, 0, WIDTH, HEIGHT};

static inline uint32_t channel(uint16_t color, int i)
{
    return i == 0 ? color >> 11U : i == 1 ? color >> 5U & 63U : color & 31U;
}

static inline void fill_random(const struct etch_surface *s, uint32_t *seed)
{
    const struct etch_rect c = s->clip;
    int32_t x, y;

    for (y = c.y0; y < c.y1; y++)
        for (x = c.x0; x < c.x1; x++)
            s->pixels[etch_surface_index(s, (int16_t)x, (int16_t)y)] =
                (uint16_t)(test_range(seed, 0, 5) == 0 ? 0xFFFF : test_random(seed) >> 16);
}

/* A random part of the window. */
static inline struct etch_rect random_clip(struct etch_rect w, uint32_t *seed)
{
    struct etch_rect c;

    c.x0 = (int16_t)test_range(seed, w.x0, w.x1 - 1);
    c.y0 = (int16_t)test_range(seed, w.y0, w.y1 - 1);
    c.x1 = (int16_t)test_range(seed, c.x0, w.x1);
    c.y1 = (int16_t)test_range(seed, c.y0, w.y1);
    return c;
}

static const struct {
    const struct etch_offset_q8 *offset;
    int32_t n;
} jitters[] = {{etch_jitter_2, 2}, {etch_jitter_4, 4}, {etch_jitter_8, 8}, {etch_jitter_16, 16}};

#endif
