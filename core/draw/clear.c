/* draw/clear.c: whole planes through the clip. Called by applications at the start of a frame.
 * See shapes.h. */
#include "../base/fill.h"
#include "shapes.h"

static void clear(const struct etch_surface *s, uint16_t *plane, uint16_t value)
{
    ETCH_ASSERT(plane != NULL && ((uintptr_t)plane & 1) == 0);

    const struct etch_rect c = s->clip;
    uint32_t width = (uint32_t)(c.x1 - c.x0), rows = (uint32_t)(c.y1 - c.y0);

    if (etch_rect_is_empty(c))
        return;
    if (width == s->stride) /* rows without a gap are one */
        width *= rows, rows = 1;
    etch_fill_rows(plane + etch_surface_index(s, c.x0, c.y0), width, value, rows, s->stride);
}

void etch_surface_clear(const struct etch_surface *s, uint16_t color)
{
    ETCH_ASSERT(s != NULL);
    clear(s, s->pixels, color);
}

void etch_depth_clear(const struct etch_surface *s, uint16_t depth)
{
    ETCH_ASSERT(s != NULL);
    clear(s, s->depth, depth);
}
