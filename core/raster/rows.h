/* raster/rows.h: shapes that know their columns row by row, to runs; no part of the API. */
#ifndef ETCH_RASTER_ROWS_H
#define ETCH_RASTER_ROWS_H

#include "../base/paint.h"

/* Columns x0 <= x < x1, of which some may lie outside every surface. */
struct etch_span {
    int32_t x0, x1;
};

/* The spans of a row, from left to right, none empty, none touching the next. */
#define ETCH_ROW_SPANS 3
struct etch_row {
    uint8_t count;
    struct etch_span span[ETCH_ROW_SPANS];
};

/* Adds a span that begins at or right of the last one's beginning, joined to it if they meet; an
 * empty one adds nothing. */
void etch_row_add(struct etch_row *row, int32_t x0, int32_t x1);

/* Adds to `row`, which is empty, the spans of frame row y. Rows are asked from top to bottom. */
typedef void etch_row_function(void *shape, int32_t y, struct etch_row *row);

/* A shape on the rows top .. bottom, inclusive. */
struct etch_rows {
    etch_row_function *row;
    void *shape;
    int32_t top, bottom;
};

/* Hands the pixels inside surface->clip to the paint, each once. */
void etch_rows_fill(const struct etch_surface *surface, const struct etch_rows *rows,
                    const struct etch_paint *paint);

/* Likewise the pixels of the shape of which one of the four neighbours is none. The shape must know
 * its spans in etch_rows_known. */
void etch_rows_outline(const struct etch_surface *surface, const struct etch_rows *rows,
                       const struct etch_paint *paint);

/* The columns of the clip, and those with the ones beside them. */
ETCH_INLINE struct etch_span etch_rows_seen(const struct etch_surface *surface)
{
    const struct etch_span v = {surface->clip.x0, surface->clip.x1};

    return v;
}

ETCH_INLINE struct etch_span etch_rows_known(const struct etch_surface *surface)
{
    const struct etch_span v = {surface->clip.x0 - 1, surface->clip.x1 + INT32_C(1)};

    return v;
}

#endif
