/* hal/strips.h: areas of a frame cut into strips. The frame loop (frame.h) and the workers
 * (workers.h) cut by it; applications do not call it. */
#ifndef ETCH_HAL_STRIPS_H
#define ETCH_HAL_STRIPS_H

#include "display.h"

struct etch_strips {
    struct etch_rect area;         /* what is left of the area in hand */
    const struct etch_rect *areas; /* those to come, */
    uint16_t left;                 /* and how many */
    int16_t rows; /* most of a strip: a multiple of the display's align_y, or all */
};

/* As many rows of `stride` elements as fit into `size`, at most the frame's; less than that, a
 * multiple of what the display wants. 0 if none fit. */
int16_t etch_strips_rows(const struct etch_display *display, uint32_t size, uint16_t stride);

/* Cuts areas[0 .. count - 1], which must stay as they are, from the top into strips of at most
 * `rows`. What of them is outside the frame is left out; borders that the display does not take
 * move outwards. */
void etch_strips_begin(struct etch_strips *strips, const struct etch_rect *areas, uint16_t count,
                       int16_t rows);

/* The next strip, of at most `size` elements, rows `stride` elements apart; stride 0: as far as
 * the area is wide. At least one row must fit. False, and *window as it was, after the last. */
bool etch_strips_next(struct etch_strips *strips, const struct etch_display *display, uint32_t size,
                      uint16_t stride, struct etch_rect *window);

#endif
