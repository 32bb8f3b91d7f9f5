/* raster/smooth_lines.h: smooth shapes that know their intervals line by line; no part of the API.
 */
#ifndef ETCH_RASTER_SMOOTH_LINES_H
#define ETCH_RASTER_SMOOTH_LINES_H

#include "rows.h"
#include "smooth_shapes.h"

/* Adds to `row`, which is empty, the intervals of the line at the height y; all in 1/256 px. Lines
 * are asked from top to bottom, 16 apart. */
struct etch_smooth_lines {
    etch_row_function *line;
    void *shape;
    int32_t top, bottom; /* what lies beyond these heights covers nothing */
};

/* The first line that is asked; of a shape that is seen. */
ETCH_INLINE int32_t etch_smooth_lines_first(const struct etch_surface *s,
                                            const struct etch_smooth_lines *lines)
{
    const int32_t top = lines->top >> 8;

    return (top > s->clip.y0 ? top : s->clip.y0) * INT32_C(256) + 8;
}

void etch_smooth_lines_fill(const struct etch_surface *s, const struct etch_smooth_lines *lines,
                            const struct etch_cover_paint *paint, int16_t *cover);

/* floor(sqrt(r^2 - y^2)), or -1 where y is beyond r; r and |y| at most 2^24. */
int32_t etch_smooth_half(int32_t r, int32_t y);

#endif
