/* tests/cli: random states over random pixels, and a triangle, line or point drawn with them
 * through a scene file; no test of its own. */
#ifndef TESTS_CLI_FRAGMENTS_SAMPLE_H
#define TESTS_CLI_FRAGMENTS_SAMPLE_H

#include <stdio.h>

#include "tests/oracle/fragment.h"

enum {
    FRAGMENTS_WIDTH = 20,
    FRAGMENTS_HEIGHT = 14,
    FRAGMENTS_PIXELS = FRAGMENTS_WIDTH * FRAGMENTS_HEIGHT
};

enum fragments_kind {
    FRAGMENTS_TRI,
    FRAGMENTS_LINE,
    FRAGMENTS_WIDE,
    FRAGMENTS_SQUARE,
    FRAGMENTS_ROUND,
    FRAGMENTS_KINDS
};

/* One case: the state, the primitive, what is there before. */
struct fragments_sample {
    enum fragments_kind kind;
    struct oracle_state state;
    struct oracle_vertex vertex[3];
    int32_t x[3], y[3]; /* 1/16 px */
    int32_t size;       /* of lines and points, 1/16 px */
    int cull, front, scissor[4];
    bool scissored, swapped;
    struct oracle_pixel before[FRAGMENTS_PIXELS];
};

/* Planes that a sample was drawn on. */
struct fragments_planes {
    uint16_t color[FRAGMENTS_PIXELS], depth[FRAGMENTS_PIXELS];
    uint8_t stencil[FRAGMENTS_PIXELS];
};

void fragments_make(struct fragments_sample *s, enum fragments_kind kind, uint32_t *seed);

/* Draws the sample's scene in strips of `rows`; false, with a failure noted, if it cannot. */
bool fragments_draw(const struct fragments_sample *s, int rows, struct fragments_planes *planes);

/* Keeps the scene as /tmp/etch-fragments-failed.scene. */
void fragments_keep(const struct fragments_sample *s);

/* Whether the scissor leaves the pixel. */
bool fragments_is_inside(const struct fragments_sample *s, int x, int y);

#endif
