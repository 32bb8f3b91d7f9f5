/* hal/frame.c: the frame loop. The application calls it; it calls the port's flush and wait.
 * At any time at most one transfer runs, and `sending` says whether. */
#include "frame.h"

/* As many rows as fit into `size` elements, at most the frame's; less than that, a multiple of
 * what the display wants. */
static int16_t rows_that_fit(const struct etch_frame *frame)
{
    const uint32_t rows = frame->memory.size / frame->stride;
    const uint8_t align = frame->display->align_y > 1 ? frame->display->align_y : 1;
    const int16_t height = frame->display->height;
    return rows < (uint32_t)height ? (int16_t)(rows / align * align) : height;
}

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
    frame->rows = frame->memory.depth != NULL || frame->memory.stencil != NULL
                      ? rows_that_fit(frame)
                      : display->height;
    return record(frame, frame->rows > 0 ? ETCH_OK : ETCH_ENOMEM);
}

static struct etch_surface *no_strip(struct etch_frame *frame)
{
    frame->surface.window.y1 = frame->surface.window.y0;
    return NULL;
}

/* The strip of the area in hand whose first row is y. */
static struct etch_surface *strip(struct etch_frame *frame, int16_t y)
{
    const struct etch_rect area = frame->area;
    const int16_t y1 = area.y1 - y > frame->rows ? (int16_t)(y + frame->rows) : area.y1;
    const struct etch_rect window = {area.x0, y, area.x1, y1};
    const size_t offset = (size_t)y * frame->stride + (size_t)area.x0;
    uint16_t *pixels = frame->direct != NULL ? frame->direct + offset
                                             : frame->memory.pixels[frame->index];

    if (etch_surface_init(&frame->surface, pixels, window, frame->stride) != ETCH_OK) {
        record(frame, ETCH_EINVAL);
        return no_strip(frame);
    }
    frame->surface.depth = frame->memory.depth;
    frame->surface.stencil = frame->memory.stencil;
    return &frame->surface;
}

/* v >= 0 down to a multiple of align; 0 and 1: any. */
static int16_t align_down(int16_t v, uint8_t align)
{
    return align > 1 ? (int16_t)(v / align * align) : v;
}

/* v > 0 up to a multiple of align, but not above the frame's border. */
static int16_t align_up(int16_t v, uint8_t align, int16_t border)
{
    const int16_t down = align_down((int16_t)(v - 1), align);

    return align <= 1 ? v : border - down > align ? (int16_t)(down + align) : border;
}

/* The part of an area that is inside the frame, with borders that the display takes. */
static struct etch_rect fit_area(const struct etch_display *d, struct etch_rect area)
{
    const struct etch_rect frame = {0, 0, d->width, d->height};
    struct etch_rect fit = etch_rect_intersect(area, frame);

    if (!etch_rect_is_empty(fit)) {
        fit.x0 = align_down(fit.x0, d->align_x);
        fit.y0 = align_down(fit.y0, d->align_y);
        fit.x1 = align_up(fit.x1, d->align_x, d->width);
        fit.y1 = align_up(fit.y1, d->align_y, d->height);
    }
    return fit;
}

/* The first strip of the next area that is not empty. */
static struct etch_surface *next_area(struct etch_frame *frame)
{
    while (frame->left > 0) {
        frame->area = fit_area(frame->display, *frame->areas++);
        frame->left--;
        if (!etch_rect_is_empty(frame->area)) {
            if (frame->direct == NULL) {
                frame->stride = (uint16_t)(frame->area.x1 - frame->area.x0);
                frame->rows = rows_that_fit(frame);
            }
            return strip(frame, frame->area.y0);
        }
    }
    return no_strip(frame);
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
    frame->areas = areas;
    frame->left = count;
    if (frame->display->memory != NULL && !take_memory(frame)) {
        return no_strip(frame);
    }
    return next_area(frame);
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
    const struct etch_rect window = frame->surface.window;
    const struct etch_rect all = {0, 0, frame->display->width, frame->display->height};
    struct etch_surface *next;

    if (etch_rect_is_empty(window)) {
        return NULL;
    }
    if (frame->direct == NULL && !send_strip(frame)) {
        return no_strip(frame);
    }
    next = window.y1 < frame->area.y1 ? strip(frame, window.y1) : next_area(frame);
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
