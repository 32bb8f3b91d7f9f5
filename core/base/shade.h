/* base/shade.h: what a light needs to know of a surface, so that the same lights serve vertices and
 * pixels. */
#ifndef ETCH_BASE_SHADE_H
#define ETCH_BASE_SHADE_H

#include "fixed.h"

/* A point of a surface in world space. */
struct etch_shade_point {
    int16_t normal[3];    /* unit, 2.14 */
    etch_q16 position[3]; /* read by point lights and, where the eye is near, by specular light */
};

/* Replaces rgb, the surface's own colour, by its lit one. `lighting` is the function's own struct:
 * those shipped are in vertex/lamp.h. */
typedef void etch_shade_function(const void *lighting, const struct etch_shade_point *point,
                                 uint8_t rgb[3]);

#endif
