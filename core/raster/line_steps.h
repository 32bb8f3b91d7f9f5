/* raster/line_steps.h: a Bresenham line and the part of it inside a clip; no part of the API.
 *
 * line.c walks the same pixels with a walk of its own, tuned to writing flat pixels. */
#ifndef ETCH_RASTER_LINE_STEPS_H
#define ETCH_RASTER_LINE_STEPS_H

#include "../base/paint.h"

/* Pixel k = 0 .. du has the major coordinate a[u] + k and the minor one m(k) steps from a's, where
 * m(k) = floor((dv k + h) / du), h = (du - 1) / 2; see line.c. */
struct etch_line_steps {
    int32_t a[2];     /* the end with the smaller major coordinate: x, y */
    uint8_t u;        /* the major axis: 0 x, 1 y */
    bool falls;       /* the minor coordinate falls from there */
    int32_t du, dv;   /* 0 .. 65535, dv <= du */
    int32_t from, to; /* the first and the last k inside the clip */
};

/* False if no pixel of the line is inside `clip`. Three 32-bit divisions at most. */
bool etch_line_steps_setup(struct etch_line_steps *s, const struct etch_rect *clip, int16_t x0,
                           int16_t y0, int16_t x1, int16_t y1);

/* Hands over the runs of that part, as etch_line_runs does. */
void etch_line_steps_runs(const struct etch_surface *surface, const struct etch_line_steps *s,
                          const struct etch_paint *paint);

/* m(k), and in *rest what the division leaves; below 65535 * 65535 + 32767 < 2^32. */
ETCH_INLINE int32_t etch_line_steps_minor(const struct etch_line_steps *s, int32_t k, int32_t *rest)
{
    const uint32_t du = (uint32_t)(s->du != 0 ? s->du : 1);
    const uint32_t n = (uint32_t)s->dv * (uint32_t)k + (du - 1) / 2;

    *rest = (int32_t)(n % du);
    return (int32_t)(n / du);
}

#endif
