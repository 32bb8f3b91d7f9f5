/* ports/lvgl/lvgl_display.c: LVGL's flush and wait to a display's. LVGL calls it. See
 * lvgl_display.h. */
#include "lvgl_display.h"

static void record(struct etch_lvgl *lvgl, int status)
{
    if (lvgl->status >= 0) {
        lvgl->status = status;
    }
}

static void settle(struct etch_lvgl *lvgl)
{
    if (lvgl->sending) {
        lvgl->sending = false;
        record(lvgl, lvgl->display->wait(lvgl->display));
    }
}

/* LVGL calls it before it draws into a buffer that is sent, and before it flushes again. */
static void wait(lv_display_t *lv)
{
    settle(lv_display_get_driver_data(lv));
}

/* Before the first area of a refresh. */
static int sync(struct etch_lvgl *lvgl)
{
    const struct etch_display *display = lvgl->display;

    if (lvgl->synced || display->sync == NULL) {
        return ETCH_OK;
    }
    lvgl->synced = true;
    return display->sync(display);
}

static void flush(lv_display_t *lv, const lv_area_t *from, uint8_t *pixels)
{
    struct etch_lvgl *lvgl = lv_display_get_driver_data(lv);
    const struct etch_display *display = lvgl->display;
    const uint32_t bytes = lv_draw_buf_width_to_stride((uint32_t)lv_area_get_width(from),
                                                       lv_display_get_color_format(lv));
    const struct etch_rect area = {(int16_t)from->x1, (int16_t)from->y1, (int16_t)(from->x2 + 1),
                                   (int16_t)(from->y2 + 1)};
    int status;

    settle(lvgl);
    status = sync(lvgl);
    if (status >= 0) {
        status = display->flush(display, area, (const uint16_t *)(const void *)pixels,
                                (uint16_t)(bytes / 2));
        lvgl->sending = status >= 0;
    }
    record(lvgl, status);
    if (lv_display_flush_is_last(lv)) {
        lvgl->synced = false;
    }
}

/* Areas grow to borders that the display takes. LVGL asks it for the rows of a buffer, too. */
static void align(lv_event_t *event)
{
    const struct etch_lvgl *lvgl = lv_event_get_user_data(event);
    const int32_t x = lvgl->display->align_x, y = lvgl->display->align_y;
    lv_area_t *area = lv_event_get_param(event);

    if (x > 1) {
        area->x1 -= area->x1 % x;
        area->x2 += x - 1 - area->x2 % x;
    }
    if (y > 1) {
        area->y1 -= area->y1 % y;
        area->y2 += y - 1 - area->y2 % y;
    }
}

lv_display_t *etch_lvgl_open(struct etch_lvgl *lvgl, const struct etch_display *display,
                             void *first, void *second, uint32_t bytes)
{
    const bool swapped = display->format == ETCH_FORMAT_RGB565_SWAPPED;
    lv_display_t *lv;

    *lvgl = (struct etch_lvgl){.display = display};
    if (display->memory != NULL) {
        return NULL;
    }
    lv = lv_display_create(display->width, display->height);
    if (lv == NULL) {
        return NULL;
    }
    lv_display_set_driver_data(lv, lvgl);
    lv_display_set_color_format(lv,
                                swapped ? LV_COLOR_FORMAT_RGB565_SWAPPED : LV_COLOR_FORMAT_RGB565);
    lv_display_set_buffers(lv, first, second, bytes, LV_DISPLAY_RENDER_MODE_PARTIAL);
    lv_display_set_flush_cb(lv, flush);
    lv_display_set_flush_wait_cb(lv, wait);
    if (display->align_x > 1 || display->align_y > 1) {
        lv_display_add_event_cb(lv, align, LV_EVENT_INVALIDATE_AREA, lvgl);
    }
    return lv;
}

int etch_lvgl_status(struct etch_lvgl *lvgl)
{
    int status;

    settle(lvgl);
    status = lvgl->status;
    lvgl->status = ETCH_OK;
    return status;
}
