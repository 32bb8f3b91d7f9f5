/* hal/worker.c: strips and parts to whoever is free, and finished strips to the display. Each
 * worker calls it in its own thread. See workers.h. */
#include "workers.h"

int etch_worker_init(struct etch_worker *w, struct etch_workers *ws,
                     struct etch_frame_memory memory)
{
    const struct etch_display *d;

    ETCH_ASSERT(w != NULL && ws != NULL);
    ETCH_ASSERT(
        (((uintptr_t)memory.pixels[0] | (uintptr_t)memory.pixels[1] | (uintptr_t)memory.depth) &
         1) == 0);
    d = ws->display;
    *w = (struct etch_worker){.workers = ws, .memory = memory, .frame = ws->frame};
    if (d->memory != NULL) {
        return ETCH_OK;
    }
    if (memory.pixels[0] == NULL || memory.pixels[0] == memory.pixels[1]) {
        return ETCH_EINVAL;
    }
    return etch_strips_rows(d, memory.size, (uint16_t)d->width) > 0 ? ETCH_OK : ETCH_ENOMEM;
}

/* Numbers of strips and phases count modulo 2^16. */
static uint16_t next(uint16_t number)
{
    return (uint16_t)((number + UINT32_C(1)) & 0xFFFF);
}

/* What follows is inside the monitor, but where it says otherwise. */

static bool takes_part(const struct etch_worker *w)
{
    return w->workers->open && w->frame == w->workers->frame;
}

bool etch_worker_begin(struct etch_worker *w)
{
    struct etch_workers *const ws = w->workers;
    bool joined;

    etch_monitor_enter(ws->monitor);
    while (!ws->closed && (!ws->open || w->frame == ws->frame)) {
        (void)etch_monitor_wait(ws->monitor, 0);
    }
    joined = !ws->closed;
    w->frame = ws->frame;
    w->phase = 0;
    w->index = 0;
    etch_monitor_leave(ws->monitor);
    return joined;
}

/* ---- shared work ----------------------------------------------------------------------------- */

/* Hands out a part of this worker's phase, or waits until all are done: false. */
static bool take_part(struct etch_worker *w, uint16_t count, uint16_t *part)
{
    struct etch_workers *const ws = w->workers;

    while (takes_part(w) && ws->phase == w->phase) {
        if (ws->part < count) {
            *part = ws->part++;
            ws->in_hand++;
            return true;
        }
        (void)etch_monitor_wait(ws->monitor, 0);
    }
    w->phase = next(w->phase);
    return false;
}

/* The last of a phase opens the next. */
static void end_part(struct etch_workers *ws, uint16_t count)
{
    ws->in_hand--;
    if (++ws->parts_done == count) {
        ws->parts_done = ws->part = 0;
        ws->phase = next(ws->phase);
        etch_monitor_signal(ws->monitor);
    }
}

bool etch_worker_part(struct etch_worker *w, uint16_t count, uint16_t *part)
{
    struct etch_workers *const ws = w->workers;

    etch_monitor_enter(ws->monitor);
    if (w->has_part) {
        end_part(ws, count);
    }
    w->has_part = take_part(w, count, part);
    etch_monitor_leave(ws->monitor);
    return w->has_part;
}

/* ---- strips ---------------------------------------------------------------------------------- */

/* Outside the monitor, but nobody else calls the display: waits for the transfer that runs, then
 * starts this worker's. */
static int send_strip(struct etch_workers *ws, const struct etch_worker *w)
{
    const struct etch_display *const d = ws->display;
    int status = ETCH_OK;

    if (ws->sending) {
        ws->sending = false;
        status = d->wait(d);
    }
    if (status >= 0 && !ws->synced && d->sync != NULL) {
        status = d->sync(d);
    }
    ws->synced = true;
    if (status >= 0) {
        status = d->flush(d, w->surface.window, w->surface.pixels, w->surface.stride);
        ws->sending = status >= 0;
    }
    if (ws->sending && w->memory.pixels[1] == NULL) { /* the only buffer is drawn on next */
        ws->sending = false;
        status = d->wait(d);
    }
    return status;
}

/* Waits until the display is this worker's, and its strip's turn where that counts; false if there
 * was an error meanwhile. */
static bool take_display(struct etch_workers *ws, uint16_t strip)
{
    const bool in_order = ws->display->in_order || ws->display->sync != NULL;

    while (ws->status >= 0 && (ws->busy || (in_order && ws->turn != strip))) {
        (void)etch_monitor_wait(ws->monitor, 0);
    }
    return ws->status >= 0;
}

/* Gives the strip in hand back: sent, or not after an error. */
static void end_strip(struct etch_worker *w)
{
    struct etch_workers *const ws = w->workers;
    int status;

    if (ws->direct == NULL && take_display(ws, w->strip)) {
        ws->busy = true;
        etch_monitor_leave(ws->monitor);
        status = send_strip(ws, w);
        etch_monitor_enter(ws->monitor);
        ws->busy = false;
        ws->turn = next(ws->turn);
        if (ws->status >= 0) {
            ws->status = status;
        }
        if (w->memory.pixels[1] != NULL) {
            w->index ^= 1; /* free: its transfer was waited for before this one was started */
        }
    }
    w->surface.window.y1 = w->surface.window.y0;
    ws->in_hand--;
    etch_monitor_signal(ws->monitor);
}

/* The memory of a strip becomes the surface. */
static int open_strip(struct etch_worker *w, struct etch_rect window)
{
    const struct etch_workers *const ws = w->workers;
    uint16_t *pixels = w->memory.pixels[w->index];
    uint16_t stride = (uint16_t)(window.x1 - window.x0);
    int status;

    if (ws->direct != NULL) {
        stride = ws->stride;
        pixels = ws->direct + (size_t)window.y0 * stride + (size_t)window.x0;
    }
    status = etch_surface_init(&w->surface, pixels, window, stride);
    w->surface.depth = w->memory.depth;
    w->surface.stencil = w->memory.stencil;
    return status;
}

/* Most elements of this worker's strips. */
static uint32_t strip_size(const struct etch_worker *w)
{
    const bool planes = w->memory.depth != NULL || w->memory.stencil != NULL;

    return w->workers->direct == NULL || planes ? w->memory.size : UINT32_MAX;
}

/* The next strip, if there is one. */
static bool take_strip(struct etch_worker *w)
{
    struct etch_workers *const ws = w->workers;
    const uint32_t size = strip_size(w);
    struct etch_rect window;

    if (!takes_part(w) || ws->status < 0) {
        return false;
    }
    if (etch_strips_rows(ws->display, size, ws->stride) < 1) {
        ws->status = ETCH_ENOMEM;
    } else if (etch_strips_next(&ws->strips, ws->display, size, ws->direct != NULL ? ws->stride : 0,
                                &window)) {
        ws->status = open_strip(w, window);
    } else {
        ws->exhausted = true;
    }
    if (ws->status < 0 || ws->exhausted) {
        etch_monitor_signal(ws->monitor); /* for who ends the frame */
        return false;
    }
    w->strip = ws->strip;
    ws->strip = next(ws->strip);
    ws->in_hand++;
    return true;
}

struct etch_surface *etch_worker_next(struct etch_worker *w)
{
    const struct etch_workers *const ws = w->workers;
    bool taken;

    etch_monitor_enter(ws->monitor);
    if (!etch_rect_is_empty(w->surface.window)) {
        end_strip(w);
    }
    taken = take_strip(w);
    etch_monitor_leave(ws->monitor);
    return taken ? &w->surface : NULL;
}
