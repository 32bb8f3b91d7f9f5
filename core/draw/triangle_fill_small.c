/* draw/triangle_fill_small.c: a triangle of pixel centres in one colour, in few bytes. Called by
 * applications. See triangle_small.h. */
#include "../fragment/flat_small.h"
#include "../raster/triangle_small.h"
#include "triangle_small.h"

/* The centre of pixel column or row i. */
static int32_t centre_q8(int16_t i)
{
    return (int32_t)i * 256 + 128;
}

void etch_triangle_fill_small(const struct etch_surface *s, int16_t x0, int16_t y0, int16_t x1,
                              int16_t y1, int16_t x2, int16_t y2, uint16_t color)
{
    const struct etch_flat_paint paint = {{etch_kernel_flat_small}, color};
    const struct etch_point_q8 v[3] = {{centre_q8(x0), centre_q8(y0)},
                                       {centre_q8(x1), centre_q8(y1)},
                                       {centre_q8(x2), centre_q8(y2)}};

    etch_triangle_runs_small(s, v, &paint.paint);
}
