/* tests/targets: the scenes that boards draw, and the host, to compare. Integers and the public API
 * only; any frame size. A firmware links one of them. */
#ifndef TESTS_TARGETS_SCENES_H
#define TESTS_TARGETS_SCENES_H

#include "core/base/rgb565.h"
#include "core/base/surface.h"

struct target_scene {
    const char *name;
    void (*prepare)(int16_t width, int16_t height);                       /* once a frame */
    void (*draw)(const struct etch_surface *strip, bool high_byte_first); /* once a strip */
};

extern const struct target_scene target_shapes; /* 2D, across the borders */
extern const struct target_scene target_torus;  /* 100 triangles, lit, with depth: 6 KB of RAM */
extern const struct target_scene target_mesh;   /* the same of 1000: 40 KB */
extern const struct target_scene target_spin;   /* the torus, turned from frame to frame */
extern const struct target_scene target_floor;  /* a texture in perspective */

ETCH_INLINE uint16_t target_color(bool high_byte_first, uint8_t r, uint8_t g, uint8_t b)
{
    const uint16_t c = etch_rgb565(r, g, b);

    return high_byte_first ? etch_rgb565_swap(c) : c;
}

#endif
