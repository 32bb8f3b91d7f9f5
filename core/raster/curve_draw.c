/* raster/curve_draw.c: the points of a curve to polylines. Called by curve_quadratic_draw.c and
 * curve_cubic_draw.c. See curve.h. */
#include "curve_draw.h"

void etch_curve_pen_down(struct etch_curve_pen *pen, const struct etch_surface *s,
                         struct etch_point at, uint16_t color)
{
    pen->surface = s;
    pen->color = color;
    pen->count = 1;
    pen->point[0] = at;
}

void etch_curve_pen_up(struct etch_curve_pen *pen)
{
    etch_polyline_draw(pen->surface, pen->point, pen->count, pen->color);
}

/* The pixel of a point is the one that it is in: nothing on the curve is beyond its control points,
 * so it fits. */
void etch_curve_pen_move(void *context, struct etch_point_q8 to)
{
    struct etch_curve_pen *const pen = context;

    if (pen->count == ETCH_CURVE_PEN) {
        etch_curve_pen_up(pen);
        pen->point[0] = pen->point[ETCH_CURVE_PEN - 1];
        pen->count = 1;
    }
    pen->point[pen->count].x = (int16_t)(to.x >> 8);
    pen->point[pen->count++].y = (int16_t)(to.y >> 8);
}
