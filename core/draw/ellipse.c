/* draw/ellipse.c: ellipses in one colour. Called by applications. See round.h. */
#include "../fragment/flat.h"
#include "../raster/ellipse.h"
#include "round.h"

void etch_ellipse_fill(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t rx, int16_t ry,
                       uint16_t color)
{
    const struct etch_flat_paint paint = {{etch_kernel_flat}, color};

    etch_ellipse_runs(s, cx, cy, rx, ry, &paint.paint);
}

void etch_ellipse_draw(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t rx, int16_t ry,
                       uint16_t color)
{
    const struct etch_flat_paint paint = {{etch_kernel_flat}, color};

    etch_ellipse_outline_runs(s, cx, cy, rx, ry, &paint.paint);
}
