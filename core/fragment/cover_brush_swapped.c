/* fragment/cover_brush_swapped.c: a brush by covers. Smooth shapes call it. See brush.h. */
#include "cover_brush_template.h"

void etch_cover_brush_swapped(const struct etch_surface *surface, int16_t x, int16_t y, uint16_t n,
                              const int16_t *cover, const struct etch_cover_paint *paint)
{
    cover_brush_row(surface, x, y, n, cover, (const struct etch_cover_brush_paint *)paint, true);
}
