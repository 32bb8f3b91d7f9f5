/* ports/tools/image_formats.c: the formats that etch-image makes. See image_format.h. */
#include "image_format.h"

#define PALETTE(n)                                                                                 \
    {                                                                                              \
        "index" #n, IMAGE_PALETTE, n, false, false, "etch_row_index" #n, "etch_texels_index" #n,   \
            NULL                                                                                   \
    }
#define PALETTE_KEY(n)                                                                             \
    {                                                                                              \
        "index" #n "_key", IMAGE_PALETTE, n, true, false, "etch_row_index" #n "_key",              \
            "etch_texels_index" #n, NULL                                                           \
    }

const struct image_format image_formats[] = {
    {"rgb565", IMAGE_COLORS, 16, false, false, "etch_row_rgb565", "etch_texels_rgb565", NULL},
    {"rgb565_key", IMAGE_COLORS, 16, true, false, "etch_row_rgb565_key", "etch_texels_rgb565",
     "etch_texels_unlike"},
    {"rgb565_alpha", IMAGE_COLORS, 16, false, true, "etch_row_rgb565_alpha", "etch_texels_rgb565",
     "etch_texels_mask"},
    PALETTE(8),
    PALETTE_KEY(8),
    PALETTE(4),
    PALETTE_KEY(4),
    PALETTE(2),
    PALETTE_KEY(2),
    PALETTE(1),
    PALETTE_KEY(1),
    {"mask8", IMAGE_MASK, 8, false, true, "etch_row_mask8", "etch_texels_ink", "etch_texels_mask"},
    {"mask4", IMAGE_MASK, 4, false, true, "etch_row_mask4", "etch_texels_ink", "etch_texels_mask4"},
    {NULL, IMAGE_COLORS, 0, false, false, NULL, NULL, NULL},
};
