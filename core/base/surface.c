/* base/surface.c: making and clipping surfaces. See surface.h. */
#include "surface.h"

enum etch_status etch_surface_init(struct etch_surface *s, uint16_t *pixels,
                                   struct etch_rect window, uint16_t stride)
{
    ETCH_ASSERT(s != NULL && ((uintptr_t)pixels & 1) == 0);
    if (pixels == NULL || etch_rect_is_empty(window) || window.x0 < 0 || window.y0 < 0 ||
        stride < (uint16_t)(window.x1 - window.x0))
        return ETCH_EINVAL;
    s->pixels = pixels;
    s->depth = NULL;
    s->stencil = NULL;
    s->stride = stride;
    s->window = window;
    s->clip = window;
    return ETCH_OK;
}

void etch_surface_clip(struct etch_surface *s, struct etch_rect clip)
{
    ETCH_ASSERT(s != NULL);

    const struct etch_rect both = etch_rect_intersect(clip, s->window);
    const struct etch_rect none = {s->window.x0, s->window.y0, s->window.x0, s->window.y0};

    s->clip = etch_rect_is_empty(both) ? none : both;
}
