/* tests/targets: the scenes that every board draws, and the host, to compare. Integers and the
 * public API only; any frame size. */
#ifndef TESTS_TARGETS_SCENES_H
#define TESTS_TARGETS_SCENES_H

#include "core/base/surface.h"

struct target_scene {
    const char *name;
    void (*prepare)(int16_t width, int16_t height);                       /* once a frame */
    void (*draw)(const struct etch_surface *strip, bool high_byte_first); /* once a strip */
};

/* NULL-terminated by name. */
extern const struct target_scene target_scenes[];

#endif
