/* fragment/cover.h: one colour blended by the share of the pixel that a shape covers, and by an
 * opacity.
 *
 * With w = cover opacity, 0 .. W = 4096 255, a channel becomes round((s w + d (W - w)) / W), ties
 * upwards: rounded once. Whole pixels of opacity 255 are written unread. */
#ifndef ETCH_FRAGMENT_COVER_H
#define ETCH_FRAGMENT_COVER_H

#include "../base/cover.h"

struct etch_cover_flat_paint {
    struct etch_cover_paint paint; /* .kernel = one of the two below */
    uint16_t color;                /* etch_rgb565, for both byte orders */
    uint8_t opacity;               /* 255: opaque */
};

etch_cover_kernel etch_cover_flat;
etch_cover_kernel etch_cover_flat_swapped; /* for surfaces in rgb565_swapped */

#endif
