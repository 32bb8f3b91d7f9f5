/* hal/frame.c: the frame loop. The application calls it; it calls the port's flush and wait.
 * At any time at most one transfer runs, and `sending` says whether. */
#include "frame.h"

/* As many rows as fit into `size` elements, at most the frame's. */
static int16_t rows_that_fit(const struct etch_frame *frame)
{
    const uint32_t rows = frame->memory.size / frame->stride;
    const int16_t height = frame->display->height;
    return rows < (uint32_t)height ? (int16_t)rows : height;
}

int etch_frame_init(struct etch_frame *frame, const struct etch_display *display,
                    struct etch_frame_memory memory)
{
    const bool direct = display->memory != NULL;

    *frame = (struct etch_frame){.display = display, .memory = memory};
    if (display->width < 1 || display->height < 1) {
        return ETCH_EINVAL;
    }
    if (!direct && (memory.pixels[0] == NULL || memory.pixels[0] == memory.pixels[1])) {
        return ETCH_EINVAL;
    }
    frame->stride = (uint16_t)display->width;
    frame->rows = direct ? display->height : rows_that_fit(frame);
    return frame->rows > 0 ? ETCH_OK : ETCH_ENOMEM;
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
    if (!settle(frame)) {
        return false;
    }
    if (!record(frame, frame->display->flush(frame->display, area, pixels, frame->stride))) {
        return false;
    }
    frame->sending = true;
    return true;
}

/* Takes the memory of a direct display for this frame, and as many rows at a time as its depth
 * plane holds. */
static bool take_memory(struct etch_frame *frame)
{
    const struct etch_display *display = frame->display;

    frame->direct = display->memory(display, &frame->stride);
    if (frame->direct == NULL) {
        return record(frame, ETCH_EIO);
    }
    if (frame->stride < (uint16_t)display->width) {
        return record(frame, ETCH_EINVAL);
    }
    frame->rows = frame->memory.depth != NULL ? rows_that_fit(frame) : display->height;
    return record(frame, frame->rows > 0 ? ETCH_OK : ETCH_ENOMEM);
}

static struct etch_surface *no_strip(struct etch_frame *frame)
{
    frame->surface.window.y1 = frame->surface.window.y0;
    return NULL;
}

/* The strip whose first row is y. */
static struct etch_surface *strip(struct etch_frame *frame, int16_t y)
{
    const int16_t height = frame->display->height;
    const int16_t y1 = height - y > frame->rows ? (int16_t)(y + frame->rows) : height;
    const struct etch_rect window = {0, y, frame->display->width, y1};
    uint16_t *pixels = frame->direct != NULL ? frame->direct + (size_t)y * frame->stride
                                             : frame->memory.pixels[frame->index];

    if (etch_surface_init(&frame->surface, pixels, window, frame->stride) != ETCH_OK) {
        record(frame, ETCH_EINVAL);
        return no_strip(frame);
    }
    frame->surface.depth = frame->memory.depth;
    return &frame->surface;
}

struct etch_surface *etch_frame_begin(struct etch_frame *frame)
{
    (void)settle(frame);
    frame->status = ETCH_OK;
    frame->index = 0;
    frame->direct = NULL;
    if (frame->display->memory != NULL && !take_memory(frame)) {
        return no_strip(frame);
    }
    return strip(frame, 0);
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

/* A direct display is told once, when all of its memory is drawn. */
static bool send_memory(struct etch_frame *frame)
{
    const struct etch_rect all = {0, 0, frame->display->width, frame->display->height};
    return frame->surface.window.y1 < frame->display->height || send(frame, all, frame->direct);
}

struct etch_surface *etch_frame_next(struct etch_frame *frame)
{
    const struct etch_rect window = frame->surface.window;

    if (etch_rect_is_empty(window)) {
        return NULL;
    }
    if (!(frame->direct != NULL ? send_memory(frame) : send_strip(frame))) {
        return no_strip(frame);
    }
    return window.y1 < frame->display->height ? strip(frame, window.y1) : no_strip(frame);
}

int etch_frame_end(struct etch_frame *frame)
{
    (void)settle(frame);
    (void)no_strip(frame);
    return frame->status;
}
