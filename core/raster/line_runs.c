/* raster/line_runs.c: lines to runs. Called by draw/ and applications with a paint. See
 * line_runs.h.
 *
 * A flat line's row m takes the pixels from K(m) to K(m + 1) - 1 along x, where
 *
 *      K(m) = ceil((m du - h) / dv) = floor((m du - h + dv - 1) / dv)
 *
 * steps from row to row by the quotient and remainder of du / dv. Only the borders between rows are
 * needed: the first row begins and the last one ends where the line or the clip does.
 * Source: J. E. Bresenham, "Run length slice algorithm for incremental lines", 1985. */
#include "line_runs.h"

#include "line_steps.h"

/* Runs on their way to the paint. */
struct block {
    const struct etch_surface *surface;
    const struct etch_paint *paint;
    int16_t y; /* of run[0] */
    uint8_t n;
    struct etch_run run[ETCH_RUN_BLOCK];
};

static void flush(struct block *b)
{
    if (b->n != 0)
        b->paint->kernel(b->surface, b->y, b->run, b->n, b->paint);
    b->y = (int16_t)(b->y + b->n);
    b->n = 0;
}

static void put(struct block *b, int32_t x0, int32_t x1)
{
    b->run[b->n].x0 = (int16_t)x0;
    b->run[b->n].x1 = (int16_t)x1;
    if (++b->n == ETCH_RUN_BLOCK)
        flush(b);
}

/* Rows of one pixel. */
static void steep(struct block *b, const struct etch_line_steps *s)
{
    int32_t rest;
    const int32_t m = etch_line_steps_minor(s, s->from, &rest);
    const int32_t aside = s->falls ? -1 : 1;
    int32_t x = s->a[0] + (s->falls ? -m : m);

    b->y = (int16_t)(s->a[1] + s->from);
    for (int32_t k = s->from; k <= s->to; k++) {
        put(b, x, x + 1);
        rest += s->dv;
        if (rest >= s->du)
            rest -= s->du, x += aside;
    }
}

/* Rows of some pixels: m grows downwards, or falls. */
static void flat(struct block *b, const struct etch_line_steps *s)
{
    int32_t rest;
    const int32_t first = etch_line_steps_minor(s, s->from, &rest);
    const int32_t last = etch_line_steps_minor(s, s->to, &rest);
    const int32_t end = s->falls ? s->a[0] + s->from : s->a[0] + s->to + 1;
    int32_t x = s->falls ? s->a[0] + s->to + 1 : s->a[0] + s->from;

    b->y = (int16_t)(s->falls ? s->a[1] - last : s->a[1] + first);
    if (first != last) {
        const int32_t dv = s->dv, h = (s->du - 1) / 2;
        const uint32_t n = (uint32_t)(s->falls ? last : first + 1) * (uint32_t)s->du;
        const uint32_t from_h = n - (uint32_t)h + (uint32_t)dv - 1;
        const int32_t quotient = s->falls ? -(s->du / dv) : s->du / dv;
        const int32_t remainder = s->falls ? -(s->du % dv) : s->du % dv;
        int32_t border = s->a[0] + (int32_t)(from_h / (uint32_t)dv);

        rest = (int32_t)(from_h % (uint32_t)dv);
        for (int32_t m = first; m < last; m++) {
            put(b, s->falls ? border : x, s->falls ? x : border);
            x = border;
            border += quotient;
            rest += remainder;
            if (rest >= dv)
                rest -= dv, border++;
            else if (rest < 0)
                rest += dv, border--;
        }
    }
    put(b, s->falls ? end : x, s->falls ? x : end);
}

void etch_line_steps_runs(const struct etch_surface *surface, const struct etch_line_steps *s,
                          const struct etch_paint *paint)
{
    struct block b;

    b.surface = surface;
    b.paint = paint;
    b.n = 0;
    if (s->u != 0)
        steep(&b, s);
    else
        flat(&b, s);
    flush(&b);
}

void etch_line_runs(const struct etch_surface *surface, int16_t x0, int16_t y0, int16_t x1,
                    int16_t y1, const struct etch_paint *paint)
{
    struct etch_line_steps s;

    if (etch_line_steps_setup(&s, &surface->clip, x0, y0, x1, y1))
        etch_line_steps_runs(surface, &s, paint);
}
