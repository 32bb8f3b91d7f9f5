/* ports/lvgl/lvgl_surface.h: a scene of etch's inside an image or a canvas of LVGL's: etch draws
 * into the draw buffer that the widget shows.
 *
 *      LV_DRAW_BUF_DEFINE_STATIC(view, 160, 120, LV_COLOR_FORMAT_RGB565);
 *      LV_DRAW_BUF_INIT_STATIC(view);
 *      struct etch_surface s;
 *      status = etch_lvgl_surface(&s, &view);
 *      draw_scene(&s);                                 the buffer's (0, 0) is the scene's
 *      lv_image_set_src(image, &view);                 or lv_canvas_set_draw_buf(canvas, &view)
 *
 * After drawing again: lv_obj_invalidate(widget), not while LVGL draws.
 */
#ifndef ETCH_PORTS_LVGL_SURFACE_H
#define ETCH_PORTS_LVGL_SURFACE_H

#include "lvgl.h"

#include "../../core/base/surface.h"

/* Makes a surface over the pixels of a draw buffer, which stays LVGL's. ETCH_EINVAL unless it is
 * RGB565 (or RGB565_SWAPPED: draw with swapped colours) and 1 .. 32767 px wide and high. */
enum etch_status etch_lvgl_surface(struct etch_surface *surface, const lv_draw_buf_t *buffer);

#endif
