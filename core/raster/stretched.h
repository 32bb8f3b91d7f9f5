/* raster/stretched.h: an ellipse drawn apart in both directions: ellipses and rounded rectangles;
 * no part of the API.
 *
 *        x0   x1
 *       .######.
 *    y0 #+----+#     the box of the centres and what lies up to rx, ry round it
 *    y1 #+----+#
 *       .######.
 */
#ifndef ETCH_RASTER_STRETCHED_H
#define ETCH_RASTER_STRETCHED_H

#include "oval.h"

struct etch_stretched {
    int32_t x0, y0, x1, y1; /* inclusive */
    struct etch_oval oval;
    struct etch_oval_edge edge;
    struct etch_oval_edge outer; /* of the row further from the centre; moved by outlines */
};

/* False if nothing of it can be seen: w or h of the box below 1, a radius below 0, or beside the
 * clip. */
bool etch_stretched_init(struct etch_stretched *p, const struct etch_surface *s, int32_t rx,
                         int32_t ry);

/* The box and radius of a rounded rectangle; p->oval is not set yet. Returns the radius, -1 without
 * one. */
int32_t etch_stretched_box(struct etch_stretched *p, int16_t x, int16_t y, int16_t w, int16_t h,
                           int16_t r);

void etch_stretched_fill(const struct etch_surface *s, struct etch_stretched *p,
                         const struct etch_paint *paint);
void etch_stretched_outline(const struct etch_surface *s, struct etch_stretched *p,
                            const struct etch_paint *paint);

#endif
