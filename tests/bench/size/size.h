/* size/size.h: what the programs of `make size` share: a frame of the caller's memory. Each
 * program is a `main` that draws one kind of thing with values the compiler cannot see, so that
 * everything a real application would link is linked, and little else. */
#ifndef SIZE_SIZE_H
#define SIZE_SIZE_H

#include "../../../core/base/surface.h"

int main(void);

static uint16_t size_pixels[320 * 240] __attribute__((unused));
static uint16_t size_depth[320 * 240] __attribute__((unused));

#define SIZE_SURFACE(depth_plane)                                                                  \
    {                                                                                              \
        .pixels = size_pixels, .depth = (depth_plane), .stride = 320, .window = {0, 0, 320, 240},  \
        .clip = {                                                                                  \
            0,                                                                                     \
            0,                                                                                     \
            320,                                                                                   \
            240                                                                                    \
        }                                                                                          \
    }

#endif
