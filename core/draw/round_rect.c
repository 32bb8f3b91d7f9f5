/* draw/round_rect.c: rounded rectangles in one colour. Called by applications. See round.h. */
#include "../fragment/flat.h"
#include "../raster/round_rect.h"
#include "round.h"

void etch_round_rect_fill(const struct etch_surface *s, int16_t x, int16_t y, int16_t w, int16_t h,
                          int16_t r, uint16_t color)
{
    const struct etch_flat_paint paint = {{etch_kernel_flat}, color};

    etch_round_rect_runs(s, x, y, w, h, r, &paint.paint);
}

void etch_round_rect_draw(const struct etch_surface *s, int16_t x, int16_t y, int16_t w, int16_t h,
                          int16_t r, uint16_t color)
{
    const struct etch_flat_paint paint = {{etch_kernel_flat}, color};

    etch_round_rect_outline_runs(s, x, y, w, h, r, &paint.paint);
}
