/* hal/workers.c: frames for several workers. The one that owns the frames calls it; worker.c hands
 * out what a frame consists of. See workers.h. */
#include "workers.h"

int etch_workers_init(struct etch_workers *ws, const struct etch_display *display,
                      const struct etch_monitor *monitor, int16_t rows)
{
    uint8_t align;

    ETCH_ASSERT(ws != NULL && display != NULL && display->flush != NULL && display->wait != NULL &&
                monitor != NULL);
    align = display->align_y > 1 ? display->align_y : 1;
    *ws = (struct etch_workers){.display = display, .monitor = monitor};
    ws->rows = rows < display->height ? (int16_t)(rows / align * align) : display->height;
    return display->width < 1 || ws->rows < 1 ? ETCH_EINVAL : ETCH_OK;
}

void etch_workers_begin_areas(struct etch_workers *ws, const struct etch_rect *areas,
                              uint16_t count)
{
    const struct etch_display *const d = ws->display;
    uint16_t stride = (uint16_t)d->width;
    uint16_t *direct;

    ETCH_ASSERT(!ws->open && (areas != NULL || count == 0));
    direct = d->memory != NULL ? d->memory(d, &stride) : NULL;
    etch_monitor_enter(ws->monitor);
    etch_strips_begin(&ws->strips, areas, count, ws->rows);
    ws->frame = (uint16_t)((ws->frame + UINT32_C(1)) & 0xFFFF);
    ws->strip = ws->turn = ws->phase = ws->part = ws->parts_done = 0;
    ws->exhausted = ws->synced = false;
    ws->direct = direct;
    ws->stride = stride;
    ws->status = d->memory != NULL && direct == NULL ? ETCH_EIO
                 : stride < (uint16_t)d->width       ? ETCH_EINVAL
                                                     : ETCH_OK;
    ws->open = true;
    etch_monitor_signal(ws->monitor);
    etch_monitor_leave(ws->monitor);
}

void etch_workers_begin(struct etch_workers *ws)
{
    ws->whole = (struct etch_rect){0, 0, ws->display->width, ws->display->height};
    etch_workers_begin_areas(ws, &ws->whole, 1);
}

/* When all workers are done: shows the memory of a direct display, waits for the last transfer. */
static int end_display(struct etch_workers *ws)
{
    const struct etch_display *const d = ws->display;
    const struct etch_rect all = {0, 0, d->width, d->height};
    int status = ws->status;
    int ended;

    if (status >= 0 && ws->direct != NULL && d->sync != NULL) {
        status = d->sync(d);
    }
    if (status >= 0 && ws->direct != NULL) {
        status = d->flush(d, all, ws->direct, ws->stride);
        ws->sending = status >= 0;
    }
    if (!ws->sending) {
        return status;
    }
    ws->sending = false;
    ended = d->wait(d);
    return status < 0 ? status : ended;
}

int etch_workers_end(struct etch_workers *ws)
{
    etch_monitor_enter(ws->monitor);
    while (ws->in_hand > 0 || (ws->status >= 0 && !ws->exhausted)) {
        (void)etch_monitor_wait(ws->monitor, 0);
    }
    ws->open = false;
    etch_monitor_signal(ws->monitor);
    etch_monitor_leave(ws->monitor);
    return end_display(ws); /* nobody else calls the display now */
}

void etch_workers_close(struct etch_workers *ws)
{
    etch_monitor_enter(ws->monitor);
    ws->closed = true;
    etch_monitor_signal(ws->monitor);
    etch_monitor_leave(ws->monitor);
}
