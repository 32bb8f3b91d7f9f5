/* draw/disc.c: discs in one colour. Called by applications. See shapes.h. */
#include "../fragment/flat.h"
#include "../raster/circle.h"
#include "shapes.h"

void etch_circle_fill(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t r,
                      uint16_t color)
{
    const struct etch_flat_paint paint = {{etch_kernel_flat}, color};

    etch_circle_runs(s, cx, cy, r, &paint.paint);
}
