/* ports/lvgl/lvgl_surface.c: LVGL's draw buffer as a surface. The application calls it. See
 * lvgl_surface.h. */
#include "lvgl_surface.h"

enum etch_status etch_lvgl_surface(struct etch_surface *surface, const lv_draw_buf_t *buffer)
{
    const uint32_t w = buffer->header.w, h = buffer->header.h, stride = buffer->header.stride;
    const bool takes = buffer->header.cf == LV_COLOR_FORMAT_RGB565 ||
                       buffer->header.cf == LV_COLOR_FORMAT_RGB565_SWAPPED;

    if (!takes || w > INT16_MAX || h > INT16_MAX || stride % 2 != 0) {
        return ETCH_EINVAL;
    }
    return etch_surface_init(surface, (uint16_t *)(void *)buffer->data,
                             (struct etch_rect){0, 0, (int16_t)w, (int16_t)h},
                             (uint16_t)(stride / 2));
}
