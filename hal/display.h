/* hal/display.h: what a display is.
 *
 * One constant struct that a port fills and the frame loop (hal/frame.h) reads. Two kinds:
 *
 *   flushed   pixels are drawn into a strip in RAM and sent: an SPI or parallel panel with its
 *             own memory, a window of a desktop, a file. `memory` is NULL.
 *   direct    pixels are drawn into the memory that the glass shows: `memory` hands it out.
 *
 * A port knows nothing about drawing, and drawing nothing about ports. Several displays of
 * different kinds work side by side: all state is behind `context`. Members added later come
 * last and mean "absent" when zero, so ports written with designated initialisers go on
 * working.
 */
#ifndef ETCH_HAL_DISPLAY_H
#define ETCH_HAL_DISPLAY_H

#include "../core/base/rgb565.h"
#include "../core/base/surface.h"

/* The order of a pixel's two bytes in memory. */
enum etch_format {
    ETCH_FORMAT_RGB565 = 0,        /* a uint16_t rrrrrggggggbbbbb of this CPU */
    ETCH_FORMAT_RGB565_SWAPPED = 1 /* the same with its bytes exchanged: a little-endian CPU
                                      then has the high byte first, as SPI panels take it */
};

/* The one of the two that has the high byte first in the memory of this CPU. */
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
#define ETCH_FORMAT_HIGH_BYTE_FIRST ETCH_FORMAT_RGB565
#else
#define ETCH_FORMAT_HIGH_BYTE_FIRST ETCH_FORMAT_RGB565_SWAPPED
#endif

struct etch_display {
    /* The port's own data, handed to nobody else. May be NULL. */
    void *context;

    /* Size of the frame in pixels, 1 .. 32767 each, after any rotation the port does. */
    int16_t width, height;

    /* An enum etch_format: how the pixels that flush gets, or those in memory, are stored. */
    uint8_t format;

    /* Starts to show pixels, and may return before the transfer has ended.
     *
     * area     pixels of the frame to change; never empty, inside 0 .. width x 0 .. height
     * pixels   pixel (area.x0, area.y0), in `format`; rows are `stride` elements apart. On a
     *          direct display this is a place in its own memory: clean the cache over it, show
     *          the page, or do nothing.
     * stride   at least area.x1 - area.x0
     *
     * Ownership: from the call until wait returns, the pixels belong to the port, which may
     * read but not change them; the caller writes nothing there. Afterwards the port holds no
     * pointer to them. At most one transfer runs: whoever calls flush calls wait before
     * calling it again.
     * Returns 0, or a negative number of the port's choosing (ETCH_EIO if it has none of its
     * own), which reaches the caller of the frame loop unchanged. A flush that fails has
     * started no transfer, or has stopped it before it returns: the pixels are the caller's.
     * Called from the thread that draws, never from an interrupt. What the port's own
     * interrupt does with the rest of the transfer is its affair. Several workers (workers.h) call
     * flush, wait and sync one at a time; who waits need not be who flushed. */
    int (*flush)(const struct etch_display *display, struct etch_rect area, const uint16_t *pixels,
                 uint16_t stride);

    /* Returns when the transfer that flush started has ended; at once if none runs. A port
     * whose flush sends everything before it returns has nothing to do here.
     * Returns 0, or the negative number with which the transfer failed; it is over then, too,
     * and is reported once. May sleep, or wait for an event or a semaphore that the port's
     * interrupt gives. A port whose hardware can stall bounds the time itself, and stops the
     * transfer before it returns the error. Called from the thread that draws. */
    int (*wait)(const struct etch_display *display);

    /* NULL for a flushed display. A direct one returns the memory to draw the next frame into,
     * a uint16_t for each pixel, and sets *stride, elements from row to row (width .. 65535).
     * Called once at the begin of a frame, so a port with two pages can hand out the hidden
     * one. The memory stays the drawing side's until the flush that ends the frame, whose area
     * is the whole frame. NULL if there is none to be had: the frame fails with ETCH_EIO. */
    uint16_t *(*memory)(const struct etch_display *display, uint16_t *stride);

    /* A display with several pixels in a byte takes areas whose borders are multiples of these,
     * or the frame's own; 0 and 1: any. The frame loop keeps to it. */
    uint8_t align_x, align_y;

    /* NULL, or called once a frame, before its first flush, from the thread that draws: returns
     * when the frame may be sent without tearing, e.g. after the pulse of the tearing-effect
     * line and the pause that etch_scan_plan gives (hal/scan.h). An error ends the frame. */
    int (*sync)(const struct etch_display *display);

    /* Several workers (hal/workers.h) send their strips from the top to the bottom, as one would;
     * those of a display with `sync` do so anyway. */
    bool in_order;
};

/* The pixel value of an 8-bit colour on this display, for the drawing functions' `color`. */
ETCH_INLINE uint16_t etch_display_color(const struct etch_display *display, uint8_t r, uint8_t g,
                                        uint8_t b)
{
    const uint16_t color = etch_rgb565(r, g, b);
    return display->format == ETCH_FORMAT_RGB565_SWAPPED ? etch_rgb565_swap(color) : color;
}

#endif
