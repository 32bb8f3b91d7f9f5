/* draw/rect.c: rectangles in one colour: raster runs joined with the flat kernel.
 * Called by applications. See shapes.h. */
#include "shapes.h"
#include "../fragment/flat.h"
#include "../raster/rect.h"

void etch_rect_fill(const struct etch_surface *s, int16_t x, int16_t y, int16_t w, int16_t h,
                    uint16_t color)
{
    const struct etch_flat_paint paint = {{etch_kernel_flat}, color};

    etch_rect_runs(s, etch_rect_from_size(x, y, w, h), &paint.paint);
}
