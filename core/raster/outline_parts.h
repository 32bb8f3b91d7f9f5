/* raster/outline_parts.h: points on outlines; no part of the API. */
#ifndef ETCH_RASTER_OUTLINE_PARTS_H
#define ETCH_RASTER_OUTLINE_PARTS_H

#include "../base/trig.h"
#include "outline.h"

ETCH_INLINE int32_t outline_held(int64_t v)
{
    const int64_t most = INT32_C(1) << 23;

    return (int32_t)(v < -most ? -most : v > most ? most : v);
}

/* Rounded to nearest. */
ETCH_INLINE struct etch_point_q8 outline_at(struct etch_point_q8 c, int32_t rx, int32_t ry,
                                            uint16_t angle)
{
    const int64_t half = INT32_C(1) << 29;
    const struct etch_point_q8 p = {
        outline_held(c.x + ((etch_mul_s32(etch_cos_q30(angle), rx) + half) >> 30)),
        outline_held(c.y + ((etch_mul_s32(etch_sin_q30(angle), ry) + half) >> 30))};
    return p;
}

/* A contour while it is drawn. */
struct outline_pen {
    const struct etch_outline *o;
    struct etch_point_q8 start, at;
    bool open;
};

ETCH_INLINE void outline_to(struct outline_pen *pen, struct etch_point_q8 p)
{
    if (pen->open)
        pen->o->edge(pen->o->shape, pen->at, p);
    else
        pen->start = p;
    pen->open = true;
    pen->at = p;
}

ETCH_INLINE void outline_close(struct outline_pen *pen)
{
    if (pen->open)
        pen->o->edge(pen->o->shape, pen->at, pen->start);
}

#endif
