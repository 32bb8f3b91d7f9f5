/* hal/frame.h: the frame loop, which hands out a frame strip by strip.
 *
 *      struct etch_frame frame;
 *      const struct etch_frame_memory memory = {.pixels = {a, b}, .depth = z, .size = 320 * 16};
 *      int status = etch_frame_init(&frame, &display, memory);
 *      ...
 *      for (struct etch_surface *s = etch_frame_begin(&frame); s != NULL;
 *           s = etch_frame_next(&frame))
 *          draw_scene(s);
 *      status = etch_frame_end(&frame);
 *
 * The application draws its whole scene, clears included, on every strip, always in frame
 * coordinates; what falls outside the strip is clipped, and the pixels do not depend on where
 * strips begin. It may narrow a strip's clip; the next strip comes with its own.
 *
 * With two buffers the next strip is drawn while the last one is sent:
 *
 *      one      draw 0 | send 0 | draw 1 | send 1 | ..
 *      two      draw 0 | send 0 | send 1 | send 2 ..
 *                      | draw 1 | draw 2 | ..
 *
 * A buffer whose transfer runs is never handed out. A direct display gets one surface over its
 * own memory for the whole frame, and needs no buffers.
 */
#ifndef ETCH_HAL_FRAME_H
#define ETCH_HAL_FRAME_H

#include "strips.h"

/* The caller's memory, which must stay valid as long as the frame loop is used. */
struct etch_frame_memory {
    uint16_t *pixels[2]; /* one or two buffers of `size` pixels; [1] may be NULL. A direct
                            display ignores them */
    uint16_t *depth;     /* depth plane of `size` elements, or NULL: surfaces have none. Its
                            content is kept from strip to strip: clear it in the scene */
    uint32_t size;       /* elements in each of these. A strip has as many rows as fit: size /
                            width, at most the height, and a multiple of the display's
                            align_y; the last may have fewer. On a direct
                            display size counts for the other planes only, whose rows are as
                            far apart as the display's: if they hold fewer rows than the frame,
                            the memory is handed out in strips of that height */
    uint8_t *stencil;    /* stencil plane of `size` elements, or NULL; as the depth plane */
};

/* A frame loop. Set up by etch_frame_init, then private. */
struct etch_frame {
    const struct etch_display *display;
    struct etch_frame_memory memory;
    struct etch_surface surface; /* the strip in hand; its window is empty if there is none */
    struct etch_strips strips;   /* to come */
    struct etch_rect whole;      /* the only area of a whole frame */
    uint16_t *direct;            /* memory of a direct display during a frame */
    uint32_t size;               /* most elements in a strip */
    uint16_t stride;             /* of the planes; a flushed strip is as wide as its area */
    uint8_t index;               /* buffer of the strip in hand */
    bool sending;                /* flush was called and wait not since */
    bool synced;                 /* the display was asked when to begin */
    bool open;                   /* begun, and not ended */
    int status;                  /* first error of this frame */
};

/* Prepares a frame loop over `display`, which must stay valid; calls none of its functions.
 * ETCH_EINVAL: a width or height outside 1 .. 32767, or a flushed display without pixels[0],
 * or both buffers the same. ETCH_ENOMEM: not one row fits (on a direct display with a depth
 * plane that shows in etch_frame_begin). */
int etch_frame_init(struct etch_frame *frame, const struct etch_display *display,
                    struct etch_frame_memory memory);

/* Begins a frame and returns its first strip, top rows first; NULL if the display failed. The
 * surface belongs to the frame loop and is the caller's to draw on until the next call. A
 * frame that was not ended is ended first; if it failed, this one does not begin, and
 * etch_frame_end returns the error. */
struct etch_surface *etch_frame_begin(struct etch_frame *frame);

/* The same for parts of the frame, what is left of which stays as it was: hands out the strips of
 * areas[0], then those of areas[1] .. Strips are as wide as their area. What of an area is
 * outside the frame is left out; one that the display cannot take as it is (align_x, align_y)
 * grows. Areas may overlap: what they share is drawn and sent twice. NULL at once if all are
 * empty, or count is 0. The array must stay as it is until the frame ends; keep it if the frame
 * fails, and begin again with it. hal/dirty.h collects and merges areas. A direct display that
 * hands out two memories by turns needs the areas of two frames. */
struct etch_surface *etch_frame_begin_areas(struct etch_frame *frame, const struct etch_rect *areas,
                                            uint16_t count);

/* Sends the strip in hand and returns the next one; NULL after the last, and after an error,
 * which ends the frame: nothing more is sent. */
struct etch_surface *etch_frame_next(struct etch_frame *frame);

/* Ends the frame: waits for the transfer that may still run. All buffers are the caller's
 * again. Returns 0 or the first error of this frame, exactly as the display returned it. Left
 * early, before etch_frame_next gave NULL, the strip in hand is not sent. */
int etch_frame_end(struct etch_frame *frame);

#endif
