/* raster/point_square.c: square points to runs. Called by draw/ and applications. See
 * point_runs.h. */
#include "point_runs.h"

#include "rect.h"

/* The first pixel whose centre is at or beyond c / 512 px; |c| <= 2^24 + 2^16. */
static int16_t first_centre(int32_t c_q9)
{
    const int32_t i = (c_q9 + 255) >> 9;

    return (int16_t)(i < INT16_MIN ? INT16_MIN : i > INT16_MAX ? INT16_MAX : i);
}

void etch_point_runs_square(const struct etch_surface *surface, int32_t x_q8, int32_t y_q8,
                            uint16_t size_q8, const struct etch_paint *paint)
{
    const int32_t x = 2 * x_q8, y = 2 * y_q8, size = size_q8;
    const struct etch_rect r = {first_centre(x - size), first_centre(y - size),
                                first_centre(x + size), first_centre(y + size)};

    etch_rect_runs(surface, r, paint);
}
