/* ports/lvgl/lvgl_display.h: LVGL above, a display of etch's below: LVGL draws its widgets into
 * buffers and hands them over; the panel driver sends them, by DMA while LVGL draws on.
 *
 *      static struct etch_lvgl screen;
 *      lv_display_t *lv = etch_lvgl_open(&screen, &lcd.display, a, b, sizeof a);
 *      ...
 *      lv_timer_handler();
 *      status = etch_lvgl_status(&screen);
 *
 * Any display that is flushed (hal/display.h): each panel of ports/spi_lcd, etch_tiles before it,
 * an application's own. LVGL 9.3 or later.
 *
 * The other way round, a scene of etch's inside a widget of LVGL's, is lvgl_surface.h. */
#ifndef ETCH_PORTS_LVGL_DISPLAY_H
#define ETCH_PORTS_LVGL_DISPLAY_H

#include "lvgl.h"

#include "../../hal/display.h"

/* Set up by open; private. Must stay where it is. */
struct etch_lvgl {
    const struct etch_display *display;
    bool sending; /* flush was called and wait not since */
    bool synced;  /* this refresh has asked the display when to begin */
    int status;   /* first error since etch_lvgl_status */
};

/* Makes an LVGL display over one or two buffers (second NULL: one) of `bytes` each, aligned as
 * LVGL wants (LV_DRAW_BUF_ALIGN), which stay in use as it does. Colours have the display's format
 * and areas its alignment. NULL if LVGL has no memory left, or the display is a direct one. */
lv_display_t *etch_lvgl_open(struct etch_lvgl *lvgl, const struct etch_display *display,
                             void *first, void *second, uint32_t bytes);

/* Waits for what is being sent. 0, or the first error since the last call, exactly as the display
 * returned it; LVGL has no use for it and goes on. What was lost is on the screen again after
 * lv_obj_invalidate(lv_screen_active()). */
int etch_lvgl_status(struct etch_lvgl *lvgl);

#endif
