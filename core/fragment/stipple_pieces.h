/* fragment/stipple_pieces.h: which part of a row a stipple lets through; no part of the API. */
#ifndef ETCH_FRAGMENT_STIPPLE_PIECES_H
#define ETCH_FRAGMENT_STIPPLE_PIECES_H

#include "pattern.h"

ETCH_INLINE bool stipple_has(uint32_t pattern, int32_t k)
{
    return (pattern >> (15 - (k & 15)) & 1) != 0;
}

/* The next pixels from *x on, before x1, whose bits are set: *x .. the result. Pixel x has bit k at
 * first, and its neighbour to the right k + step. None are left if the two are equal. */
ETCH_INLINE int32_t stipple_next(uint32_t pattern, int32_t *x, int32_t x1, int32_t k, int32_t step)
{
    int32_t to;

    for (; *x < x1 && !stipple_has(pattern, k); k += step)
        ++*x;
    for (to = *x; to < x1 && stipple_has(pattern, k); k += step)
        to++;
    return to;
}

/* The pieces of a run, one kernel call each. */
ETCH_INLINE void stipple_run(const struct etch_surface *surface, int16_t y, struct etch_run run,
                             uint32_t pattern, int32_t k, int32_t step,
                             const struct etch_paint *through)
{
    int32_t x = run.x0;

    for (;;) {
        const int32_t to = stipple_next(pattern, &x, run.x1, k + step * (x - run.x0), step);
        const struct etch_run piece = {(int16_t)x, (int16_t)to};

        if (x == to)
            return;
        through->kernel(surface, y, &piece, 1, through);
        x = to;
    }
}

#endif
