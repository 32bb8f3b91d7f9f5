/* ports/host/scene_image_formats.c: the formats of the image statement. scene_image.c looks there.
 */
#include "../../core/fragment/sampler.h"
#include "scene_image.h"

#define ROW(name)                                                                                  \
    {                                                                                              \
        name, #name                                                                                \
    }
#define BOTH(name)                                                                                 \
    {                                                                                              \
        ROW(name), ROW(name)                                                                       \
    }
#define ORDERS(name)                                                                               \
    {                                                                                              \
        ROW(name), ROW(name##_swapped)                                                             \
    }
#define NONE                                                                                       \
    {                                                                                              \
        {NULL, NULL},                                                                              \
        {                                                                                          \
            NULL, NULL                                                                             \
        }                                                                                          \
    }
#define PALETTE(n)                                                                                 \
    {"index" #n,                                                                                   \
     n,                                                                                            \
     false,                                                                                        \
     false,                                                                                        \
     false,                                                                                        \
     etch_texels_index##n,                                                                         \
     NULL,                                                                                         \
     BOTH(etch_row_index##n),                                                                      \
     ORDERS(etch_row_index##n##_fade)},                                                            \
    {                                                                                              \
        "index" #n "_key", n, true, false, false, NULL, NULL, BOTH(etch_row_index##n##_key), NONE  \
    }

const struct etch_scene_format etch_scene_formats[] = {
    {"rgb565", 16, false, false, false, etch_texels_rgb565, NULL, BOTH(etch_row_rgb565),
     ORDERS(etch_row_rgb565_fade)},
    {"rgb565_key", 16, true, false, false, etch_texels_rgb565, etch_texels_unlike,
     BOTH(etch_row_rgb565_key), NONE},
    {"rgb565_alpha", 16, false, true, false, etch_texels_rgb565, etch_texels_mask,
     ORDERS(etch_row_rgb565_alpha), ORDERS(etch_row_rgb565_alpha)},
    PALETTE(8),
    PALETTE(4),
    PALETTE(2),
    PALETTE(1),
    {"mask8", 8, false, true, true, etch_texels_ink, etch_texels_mask, ORDERS(etch_row_mask8),
     ORDERS(etch_row_mask8)},
    {"mask4", 4, false, true, true, etch_texels_ink, etch_texels_mask4, ORDERS(etch_row_mask4),
     ORDERS(etch_row_mask4)},
    {NULL, 0, false, false, false, NULL, NULL, NONE, NONE},
};
