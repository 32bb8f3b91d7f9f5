/* raster/curve_draw.h: what draws the points of a curve; no part of the API. */
#ifndef ETCH_RASTER_CURVE_DRAW_H
#define ETCH_RASTER_CURVE_DRAW_H

#include "curve.h"

/* Points that wait to be drawn as one polyline. */
#define ETCH_CURVE_PEN 17

struct etch_curve_pen {
    const struct etch_surface *surface;
    uint16_t color;
    uint8_t count;
    struct etch_point point[ETCH_CURVE_PEN];
};

ETCH_INLINE struct etch_point_q8 etch_curve_centre(struct etch_point p)
{
    const struct etch_point_q8 c = {(int32_t)p.x * 256 + 128, (int32_t)p.y * 256 + 128};

    return c;
}

void etch_curve_pen_down(struct etch_curve_pen *pen, const struct etch_surface *s,
                         struct etch_point at, uint16_t color);
etch_curve_point etch_curve_pen_move; /* context: the pen */
void etch_curve_pen_up(struct etch_curve_pen *pen);

#endif
