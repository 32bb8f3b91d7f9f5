/* hal/frame.c: the frame loop. The application calls it; it calls the port's flush and wait.
 * At any time at most one transfer runs, and `sending` says whether. */
#include "frame.h"

int etch_frame_init(struct etch_frame *frame, const struct etch_display *display,
                    struct etch_frame_memory memory)
{
    bool direct;

    ETCH_ASSERT(frame != NULL && display != NULL && display->flush != NULL &&
                display->wait != NULL);
    ETCH_ASSERT(
        (((uintptr_t)memory.pixels[0] | (uintptr_t)memory.pixels[1] | (uintptr_t)memory.depth) &
         1) == 0);
    direct = display->memory != NULL;
    *frame = (struct etch_frame){.display = display, .memory = memory};
    if (display->width < 1 || display->height < 1) {
        return ETCH_EINVAL;
    }
    if (!direct && (memory.pixels[0] == NULL || memory.pixels[0] == memory.pixels[1])) {
        return ETCH_EINVAL;
    }
    frame->stride = (uint16_t)display->width;
    return direct || etch_strips_rows(display, memory.size, frame->stride) > 0 ? ETCH_OK
                                                                               : ETCH_ENOMEM;
}

/* Keeps the first error. True if there is none. */
static bool record(struct etch_frame *frame, int status)
{
    if (frame->status == ETCH_OK) {
        frame->status = status;
    }
    return frame->status == ETCH_OK;
}

/* Waits for the transfer that runs, if one does. */
static bool settle(struct etch_frame *frame)
{
    if (!frame->sending) {
        return frame->status == ETCH_OK;
    }
    frame->sending = false;
    return record(frame, frame->display->wait(frame->display));
}

static bool send(struct etch_frame *frame, struct etch_rect area, const uint16_t *pixels)
{
    const struct etch_display *display = frame->display;

    if (!settle(frame)) {
        return false;
    }
    if (!frame->synced && display->sync != NULL && !record(frame, display->sync(display))) {
        return false;
    }
    frame->synced = true;
    if (!record(frame, display->flush(display, area, pixels, frame->stride))) {
        return false;
    }
    frame->sending = true;
    return true;
}

/* Takes the memory of a direct display for this frame, and as many rows at a time as its other
 * planes hold. */
static bool take_memory(struct etch_frame *frame)
{
    const struct etch_display *display = frame->display;
    const bool planes = frame->memory.depth != NULL || frame->memory.stencil != NULL;

    frame->direct = display->memory(display, &frame->stride);
    if (frame->direct == NULL) {
        return record(frame, ETCH_EIO);
    }
    if (frame->stride < (uint16_t)display->width) {
        return record(frame, ETCH_EINVAL);
    }
    frame->size = planes ? frame->memory.size : UINT32_MAX;
    return record(frame, etch_strips_rows(display, frame->size, frame->stride) > 0 ? ETCH_OK
                                                                                   : ETCH_ENOMEM);
}

static struct etch_surface *no_strip(struct etch_frame *frame)
{
    frame->surface.window.y1 = frame->surface.window.y0;
    return NULL;
}

/* The next strip to draw. */
static struct etch_surface *take_strip(struct etch_frame *frame)
{
    const bool direct = frame->direct != NULL;
    uint16_t *pixels = frame->memory.pixels[frame->index];
    struct etch_rect window;

    if (!etch_strips_next(&frame->strips, frame->display, frame->size, direct ? frame->stride : 0,
                          &window)) {
        return no_strip(frame);
    }
    if (direct) {
        pixels = frame->direct + (size_t)window.y0 * frame->stride + (size_t)window.x0;
    } else {
        frame->stride = (uint16_t)(window.x1 - window.x0);
    }
    if (etch_surface_init(&frame->surface, pixels, window, frame->stride) != ETCH_OK) {
        record(frame, ETCH_EINVAL);
        return no_strip(frame);
    }
    frame->surface.depth = frame->memory.depth;
    frame->surface.stencil = frame->memory.stencil;
    return &frame->surface;
}

struct etch_surface *etch_frame_begin_areas(struct etch_frame *frame, const struct etch_rect *areas,
                                            uint16_t count)
{
    ETCH_ASSERT(frame != NULL && (areas != NULL || count == 0));
    if (frame->open && !settle(frame)) {
        return no_strip(frame); /* the frame before failed, and nobody has heard of it yet */
    }
    frame->open = true;
    frame->status = ETCH_OK;
    frame->index = 0;
    frame->direct = NULL;
    frame->synced = false;
    frame->size = frame->memory.size;
    etch_strips_begin(&frame->strips, areas, count, INT16_MAX);
    if (frame->display->memory != NULL && !take_memory(frame)) {
        return no_strip(frame);
    }
    return take_strip(frame);
}

struct etch_surface *etch_frame_begin(struct etch_frame *frame)
{
    frame->whole = (struct etch_rect){0, 0, frame->display->width, frame->display->height};
    return etch_frame_begin_areas(frame, &frame->whole, 1);
}

/* Sends the strip in hand from its buffer. True if a buffer is free for the next one. */
static bool send_strip(struct etch_frame *frame)
{
    if (!send(frame, frame->surface.window, frame->memory.pixels[frame->index])) {
        return false;
    }
    if (frame->memory.pixels[1] == NULL) {
        return settle(frame);
    }
    frame->index ^= 1; /* free: the transfer before this one was waited for */
    return true;
}

struct etch_surface *etch_frame_next(struct etch_frame *frame)
{
    const struct etch_rect all = {0, 0, frame->display->width, frame->display->height};
    struct etch_surface *next;

    if (etch_rect_is_empty(frame->surface.window)) {
        return NULL;
    }
    if (frame->direct == NULL && !send_strip(frame)) {
        return no_strip(frame);
    }
    next = take_strip(frame);
    if (next == NULL && frame->direct != NULL) {
        (void)send(frame, all, frame->direct); /* told once, when all of its memory is drawn */
    }
    return next;
}

int etch_frame_end(struct etch_frame *frame)
{
    (void)settle(frame);
    (void)no_strip(frame);
    frame->open = false;
    return frame->status;
}
