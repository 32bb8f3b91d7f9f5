/* fragment/cover_flat.c: one colour by covers. Smooth shapes call it. See cover.h. */
#include "cover_template.h"

void etch_cover_flat(const struct etch_surface *surface, int16_t x, int16_t y, uint16_t n,
                     const int16_t *cover, const struct etch_cover_paint *paint)
{
    cover_row(surface, x, y, n, cover, paint, false);
}
