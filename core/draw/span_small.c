/* draw/span_small.c: a run of pixels. Called by the small shapes. See shapes_small.h. */
#include "shapes_small.h"

void etch_span_fill_small(const struct etch_surface *s, int32_t y, int32_t x0, int32_t x1,
                          uint16_t color)
{
    const int16_t left = s->clip.x0, right = s->clip.x1;
    uint16_t *p;

    x0 = x0 > left ? x0 : left;
    x1 = x1 < right ? x1 : right;
    if (x0 >= x1)
        return;
    p = s->pixels + etch_surface_index(s, (int16_t)x0, (int16_t)y);
    do
        *p++ = color;
    while (++x0 != x1);
}
