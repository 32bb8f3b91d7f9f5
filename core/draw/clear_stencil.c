/* draw/clear_stencil.c: the stencil plane through the clip. Called by applications at the start of
 * a frame. See shapes.h. */
#include "shapes.h"

void etch_stencil_clear(const struct etch_surface *s, uint8_t value)
{
    ETCH_ASSERT(s != NULL && s->stencil != NULL);

    const struct etch_rect c = s->clip;

    for (int16_t y = c.y0; y < c.y1 && c.x0 < c.x1; y++) {
        uint8_t *row = s->stencil + etch_surface_index(s, c.x0, y);

        for (int16_t x = c.x0; x < c.x1; x++)
            *row++ = value;
    }
}
