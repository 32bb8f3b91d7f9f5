/* tests/product: three screens as a product would ship, on a panel of 240 x 320 in strips of 16
 * rows, within 24 KB of RAM in all.
 *
 *      prepare(tick)   once a frame: what the sensors say at this time
 *      draw(surface)   once a strip: the whole screen; all that is outside the strip is clipped
 *
 * Surfaces are in the byte order of SPI panels, high byte first. The screens keep their state
 * and their scratch memory in statics, as firmware with one display does. */
#ifndef TESTS_PRODUCT_H
#define TESTS_PRODUCT_H

#include "core/base/surface.h"

enum {
    PRODUCT_WIDTH = 240,
    PRODUCT_HEIGHT = 320,
    PRODUCT_STRIP = 16
};

struct product_screen {
    const char *name;
    void (*prepare)(uint32_t tick);
    void (*draw)(const struct etch_surface *s);
};

extern const struct product_screen product_cluster; /* dials, needles, digits */
extern const struct product_screen product_chart;   /* scrolling lines, a legend, cards */
extern const struct product_screen product_menu;    /* glass over a photo */

#endif
