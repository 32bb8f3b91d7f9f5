/* draw/point.c: points in one colour. Called by applications. See point.h. */
#include "point.h"

#include "../fragment/flat.h"

void etch_point_fill(const struct etch_surface *s, int32_t x_q8, int32_t y_q8, uint16_t size_q8,
                     uint16_t color, etch_point_runs *runs)
{
    const struct etch_flat_paint paint = {{etch_kernel_flat}, color};

    runs(s, x_q8, y_q8, size_q8, &paint.paint);
}
