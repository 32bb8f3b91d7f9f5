/* raster/stroke_parts.h: vectors of strokes; no part of the API. */
#ifndef ETCH_RASTER_STROKE_PARTS_H
#define ETCH_RASTER_STROKE_PARTS_H

#include "outline_parts.h"
#include "stroke.h"

/* The length of (x, y) in 1/256 px, rounded down; |x|, |y| <= 2^24. */
uint32_t etch_stroke_length(int32_t x, int32_t y);

/* (x, y) times size / its length, rounded; 0 < size <= 2^24. */
struct etch_point_q8 etch_stroke_scaled(int32_t x, int32_t y, int32_t size);

/* A convex part, turned to wind downwards on its right as all others. */
void etch_stroke_convex(const struct etch_outline *o, const struct etch_point_q8 *v, uint8_t n);

ETCH_INLINE struct etch_point_q8 stroke_moved(struct etch_point_q8 p, int64_t x, int64_t y)
{
    const struct etch_point_q8 q = {outline_held(p.x + x), outline_held(p.y + y)};
    return q;
}

/* The segment from a to b, n across it. */
void etch_stroke_segment(const struct etch_outline *o, struct etch_point_q8 a,
                         struct etch_point_q8 b, struct etch_point_q8 n);

#endif
