/* draw/clear.c: whole planes through the clip. Called by applications at the start of a frame.
 * See shapes.h. */
#include "../base/fill.h"
#include "shapes.h"

static void clear(const struct etch_surface *s, uint16_t *plane, uint16_t value)
{
    const struct etch_rect c = s->clip;
    const uint16_t width = (uint16_t)(c.x1 - c.x0);
    int16_t rows = (int16_t)(c.y1 - c.y0);

    if (etch_rect_is_empty(c))
        return;
    plane += etch_surface_index(s, c.x0, c.y0);
    if (width == s->stride) { /* rows without a gap are one */
        etch_fill(plane, (size_t)width * (size_t)rows, value);
        return;
    }
    etch_fill(plane, width, value);
    while (--rows > 0) {
        plane += s->stride;
        etch_fill(plane, width, value);
    }
}

void etch_surface_clear(const struct etch_surface *s, uint16_t color)
{
    clear(s, s->pixels, color);
}

void etch_depth_clear(const struct etch_surface *s, uint16_t depth)
{
    ETCH_ASSERT(s->depth != NULL);
    clear(s, s->depth, depth);
}
