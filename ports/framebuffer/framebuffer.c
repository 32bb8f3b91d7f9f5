/* ports/framebuffer/framebuffer.c: linear memory as a display. The frame loop calls it. See
 * framebuffer.h. */
#include "framebuffer.h"

int etch_framebuffer_flush(const struct etch_display *display, struct etch_rect area,
                           const uint16_t *pixels, uint16_t stride)
{
    (void)display, (void)area, (void)pixels, (void)stride;
    return ETCH_OK;
}

int etch_framebuffer_wait(const struct etch_display *display)
{
    (void)display;
    return ETCH_OK;
}

uint16_t *etch_framebuffer_memory(const struct etch_display *display, uint16_t *stride)
{
    const struct etch_framebuffer *memory = display->context;

    *stride = memory->stride;
    return memory->pixels;
}
