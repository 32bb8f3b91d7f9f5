/* raster/curve_cubic_draw.c: cubic curves as lines. Called by applications. See curve.h. */
#include "curve_draw.h"

void etch_cubic_draw(const struct etch_surface *s, const struct etch_point p[4], uint16_t color)
{
    struct etch_point_q8 centre[4];
    struct etch_curve_pen pen;

    for (uint8_t i = 0; i < 4; i++)
        centre[i] = etch_curve_centre(p[i]);
    etch_curve_pen_down(&pen, s, p[0], color);
    etch_cubic_flatten(centre, ETCH_CURVE_FLATNESS_Q8, etch_curve_pen_move, &pen);
    etch_curve_pen_up(&pen);
}
