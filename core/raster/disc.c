/* raster/disc.c: discs to runs. Called by draw/. See circle.h.
 *
 * The outline reaches, on the row j >= 0 from the centre, the half width w
 *
 *      j <= end:  w = y(j)                  the largest w with w^2 - w < r^2 - j^2
 *      j >  end:  w = last x with y(x) = j  the largest w with w^2 < r^2 - j^2 + j
 *
 * (octants and `end` as in circle.c; y(x) >= j <=> x^2 < r^2 - j^2 + j). With steep = 1 in the
 * second case and 0 in the first, w is the largest with
 *
 *      d = w^2 + j^2 - r^2 - (steep ? j : w) < 0
 *
 * and from row to row d is kept by sums: one square root a disc, no product a row.
 */
#include "octant.h"

struct width {
    int32_t w, j, d; /* d < 0, and >= 0 for w + 1 */
    int32_t steep;   /* 1 or 0 */
    int32_t end;     /* the octant's last x */
};

static void width_set(struct width *h, int32_t r, int32_t j)
{
    const int32_t rr = r != 0 ? r * r : 1; /* r = 0: w = 0 by the second rule */

    h->end = r != 0 ? octant_end(r) : -1;
    h->steep = j > h->end;
    h->j = j;
    h->w = etch_sqrt_u32((uint32_t)(rr - j * j + (h->steep ? j : 0))) + 1; /* too much by 0 .. 2 */
    h->d = h->w * h->w + j * j - rr - (h->steep ? j : h->w);
    while (h->d >= 0) {
        h->w--;
        h->d -= 2 * h->w + h->steep;
    }
}

/* To the next row towards the centre: w grows. */
ETCH_INLINE void width_rise(struct width *h)
{
    int32_t more;

    h->j--;
    h->d -= 2 * h->j + 1 - h->steep;
    if (h->j == h->end) {
        h->d += h->j - h->w;
        h->steep = 0;
    }
    while (more = h->d + 2 * h->w + h->steep, more < 0) {
        h->d = more;
        h->w++;
    }
}

/* To the next row away from it: w shrinks, below the last row of the disc to -1. */
ETCH_INLINE void width_fall(struct width *h)
{
    h->d += 2 * h->j + 1 - h->steep;
    h->j++;
    if (h->j == h->end + 1) {
        h->d += h->w - h->j;
        h->steep = 1;
    }
    while (h->d >= 0 && h->w >= 0) {
        h->w--;
        h->d -= 2 * h->w + h->steep;
    }
}

/* The next n rows, all above the centre (rising) or all on and below it; returns the run after
 * them. */
ETCH_INLINE struct etch_run *rows(struct etch_run *run, struct width *width, int32_t n, int32_t cx,
                                  const struct etch_rect *c, bool rising)
{
    const int32_t lo = c->x0, hi = c->x1;
    struct width h = *width;

    for (; n > 0; n--, run++) {
        const int32_t left = cx - h.w, right = cx + h.w + 1;
        const int32_t x0 = left < lo ? lo : left, x1 = right > hi ? hi : right;

        run->x0 = (int16_t)x0;
        run->x1 = (int16_t)(x1 < x0 ? x0 : x1); /* beside the clip: no pixel */
        if (rising)
            width_rise(&h);
        else
            width_fall(&h);
    }
    *width = h;
    return run;
}

void etch_circle_runs(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t r,
                      const struct etch_paint *paint)
{
    const struct etch_rect c = s->clip;
    const int32_t top = (int32_t)cy - r, bottom = (int32_t)cy + r + 1;
    int32_t y = top > c.y0 ? top : c.y0;
    const int32_t y1 = bottom < c.y1 ? bottom : c.y1;
    struct etch_run runs[ETCH_RUN_BLOCK];
    struct width h;

    if (r < 0 || y >= y1 || c.x0 >= c.x1 || (int32_t)cx - r >= c.x1 || (int32_t)cx + r < c.x0)
        return;
    width_set(&h, r, y < cy ? cy - y : y - cy);
    while (y < y1) {
        const int32_t n = y1 - y < ETCH_RUN_BLOCK ? y1 - y : ETCH_RUN_BLOCK;
        const int32_t above = y < cy ? (cy - y < n ? cy - y : n) : 0;

        rows(rows(runs, &h, above, cx, &c, true), &h, n - above, cx, &c, false);
        y += n;
        paint->kernel(s, (int16_t)(y - n), runs, (uint8_t)n, paint);
    }
}
