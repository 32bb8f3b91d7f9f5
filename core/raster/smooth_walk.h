/* raster/smooth_walk.h: the rows of a shape with covers; no part of the API. */
#ifndef ETCH_RASTER_SMOOTH_WALK_H
#define ETCH_RASTER_SMOOTH_WALK_H

#include "smooth.h"

/* The changes of cover along a row, and which of its pixels are concerned. */
struct etch_smooth_row {
    int16_t *change;  /* of clip columns 0 .. width */
    int32_t left;     /* 1/256 px, of the clip's first column */
    int32_t width;    /* 1/256 px */
    int32_t from, to; /* columns touched, inclusive */
};

/* A row without changes; `cover` as for etch_smooth_fill_nonzero. */
void etch_smooth_row_init(struct etch_smooth_row *row, const struct etch_surface *s,
                          int16_t *cover);

/* Hands over what row y covers, and leaves the row without changes. */
void etch_smooth_row_end(struct etch_smooth_row *row, const struct etch_surface *s, int16_t y,
                         const struct etch_cover_paint *paint);

/* Puts the edge on a line that it crosses; and on the next one, which it crosses too. */
void etch_smooth_edge_place(struct etch_smooth_edge *g, int32_t line);
void etch_smooth_edge_step(struct etch_smooth_edge *g);

/* Adds one line's intervals: edges by rising x. */
typedef void etch_smooth_rule(struct etch_smooth_row *row, const struct etch_smooth_edge *edge);

void etch_smooth_walk(const struct etch_surface *surface, struct etch_smooth *p,
                      const struct etch_cover_paint *paint, int16_t *cover, etch_smooth_rule *line);

/* An interval begins (share = 1) or ends (-1) at x. Where one begins at f / 256 of a pixel, the
 * pixel gains 256 - f and all that follow it 256. On a line the intervals are apart, so their
 * changes of a pixel sum to -256 .. 256, and those of 16 lines to -4096 .. 4096. */
ETCH_INLINE void etch_smooth_mark(struct etch_smooth_row *row, int32_t x, int32_t share)
{
    const int32_t at = x < row->left ? 0 : x - row->left > row->width ? row->width : x - row->left;
    const int32_t i = at >> 8, part = at & 255, last = i + (part != 0);

    row->change[i] = (int16_t)(row->change[i] + share * (256 - part));
    if (part != 0)
        row->change[last] = (int16_t)(row->change[last] + share * part);
    if (i < row->from)
        row->from = i;
    if (last > row->to)
        row->to = last;
}

#endif
