/* ports/framebuffer/framebuffer.h: a display that is linear 16-bit memory.
 *
 *      static struct etch_framebuffer memory = {pixels, 320};
 *      static const struct etch_display display = {
 *          .context = &memory, .width = 320, .height = 240, .format = ETCH_FORMAT_RGB565,
 *          .flush = etch_framebuffer_flush, .wait = etch_framebuffer_wait,
 *          .memory = etch_framebuffer_memory};
 *
 * Drawing goes straight into it, nothing is sent. Hardware that needs to hear of a finished
 * frame (a cache to clean, pages to turn) puts a flush of its own in place. */
#ifndef ETCH_PORTS_FRAMEBUFFER_H
#define ETCH_PORTS_FRAMEBUFFER_H

#include "../../hal/display.h"

/* The caller's memory; pixel (0, 0) first. */
struct etch_framebuffer {
    uint16_t *pixels; /* aligned to 2 bytes */
    uint16_t stride;  /* elements from row to row, at least the display's width */
};

/* The three functions of hal/display.h; the display's context is a struct etch_framebuffer. */
int etch_framebuffer_flush(const struct etch_display *display, struct etch_rect area,
                           const uint16_t *pixels, uint16_t stride);
int etch_framebuffer_wait(const struct etch_display *display);
uint16_t *etch_framebuffer_memory(const struct etch_display *display, uint16_t *stride);

#endif
