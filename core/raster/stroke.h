/* raster/stroke.h: thick polylines as outlines, for exact and for smooth fills by the non-zero
 * rule.
 *
 * Each segment is a rectangle of the width round its middle line; joints and ends are parts of
 * their own that overlap it. All wind the same way, so that the non-zero rule makes their union: no
 * pixel twice, no blending twice. Corners are rounded to 1/256 px.
 */
#ifndef ETCH_RASTER_STROKE_H
#define ETCH_RASTER_STROKE_H

#include "outline.h"

struct etch_stroke;

/* What an end or a joint adds at p. `in` and `out` are half the width long and point across the
 * segments that meet, to the right of their way as seen with y down; at an end both are those of
 * its only segment, which leads to p. */
typedef void etch_stroke_part(const struct etch_outline *o, struct etch_point_q8 p,
                              struct etch_point_q8 in, struct etch_point_q8 out,
                              const struct etch_stroke *stroke);

struct etch_stroke {
    int32_t width_q8;       /* 2 .. 2^15, else nothing is drawn */
    etch_stroke_part *cap;  /* etch_cap_butt, etch_cap_square, etch_cap_round */
    etch_stroke_part *join; /* etch_join_miter, etch_join_bevel, etch_join_round */
    uint16_t miter_q8;      /* miters longer than this many 1/256 of the width are bevels: 1024 is
                               the 4 of SVG */
};

etch_stroke_part etch_cap_butt, etch_cap_square, etch_cap_round;
etch_stroke_part etch_join_miter, etch_join_bevel, etch_join_round;

/* The polyline v[0] .. v[n - 1], of coordinates within +-2^22; a closed one has a joint where its
 * last point meets the first, and no ends. Points equal to the one before are left out; a line of
 * no length draws nothing. Four edges a segment, 3 or 4 a joint or cap, round ones
 * etch_outline_chords(width / 2). */
void etch_stroke_outline(const struct etch_outline *o, const struct etch_point_q8 *v, uint16_t n,
                         bool closed, const struct etch_stroke *stroke);

/* The same line in dashes: dash[0] long, then a gap of dash[1], and so on round the `count` lengths
 * (even, 2 or more, each 1 .. 2^20), beginning `phase` after the start of dash[0]. Each dash has
 * caps; it bends with joints. Lengths err by 1/256 px a corner. At most 2^16 dashes. */
void etch_stroke_dashes(const struct etch_outline *o, const struct etch_point_q8 *v, uint16_t n,
                        const struct etch_stroke *stroke, const int32_t *dash, uint8_t count,
                        int32_t phase);

#endif
