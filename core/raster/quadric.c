/* raster/quadric.c: conic sections to runs. Called by applications. See quadric.h.
 *
 * Along a row F is a parabola, so with D(x) = F(x + 1) - F(x)
 *
 *      F(x + 1) = F + D,   D(x + 1) = D + 2 a,   F(x + 16) = F + 16 D + 240 a
 *
 * and F has one sign on x .. x + 15 if it has it at x and x + 16 and does not turn towards zero
 * between: below zero it may if a < 0, above zero if a > 0, and only if D changes sign on the way.
 *
 * |F| <= 3 * 2^60 + 2 * 2^59 + 2^61 < 2^63 up to 16 columns and a row beyond int16_t. */
#include "quadric.h"
#include "run_band.h"

enum {
    STRIDE = 16
};

static bool exceeds(int64_t v, uint8_t bits)
{
    return v > INT64_C(1) << bits || v < -(INT64_C(1) << bits);
}

enum etch_status etch_quadric_check(const struct etch_quadric *q)
{
    return exceeds(q->a, 30) || exceeds(q->b, 30) || exceeds(q->c, 30) || exceeds(q->d, 44) ||
                   exceeds(q->e, 44) || exceeds(q->f, 61)
               ? ETCH_EINVAL
               : ETCH_OK;
}

/* Whether F keeps its sign on x .. x + 15, with f and `after` its values at x and x + 16. */
static bool keeps_sign(int64_t f, int64_t after, int64_t step, int64_t a)
{
    const int64_t last = step + (2 * STRIDE - 2) * a;

    if ((f < 0) != (after < 0))
        return false;
    return f < 0 ? a >= 0 || step <= 0 || last >= 0 : a <= 0 || step >= 0 || last <= 0;
}

/* The runs of row y from column x to x1 - 1, with F and D at x. */
static void scan(struct etch_run_band *band, int16_t y, int32_t x, int32_t x1, int64_t f,
                 int64_t step, int64_t a)
{
    bool inside = false;
    int32_t from = x;

    while (x < x1) {
        const int64_t after = f + STRIDE * step + STRIDE * (STRIDE - 1) * a;
        int32_t n = x1 - x < STRIDE ? x1 - x : STRIDE;

        if (keeps_sign(f, after, step, a) && (f < 0) == inside) {
            x += STRIDE; /* beyond x1 in the last block, where nothing is read any more */
            f = after;
            step += 2 * STRIDE * a;
            continue;
        }
        for (; n != 0; n--, x++) {
            if ((f < 0) != inside) {
                if (inside)
                    etch_run_band_add(band, y, from, x);
                inside = !inside;
                from = x;
            }
            f += step;
            step += 2 * a;
        }
    }
    if (inside)
        etch_run_band_add(band, y, from, x1);
}

void etch_quadric_runs(const struct etch_surface *surface, const struct etch_quadric *q,
                       const struct etch_paint *paint)
{
    const struct etch_rect clip = surface->clip;
    const int64_t x = clip.x0, y0 = clip.y0, a = q->a, b = q->b, c = q->c;
    int64_t f = a * x * x + b * x * y0 + c * y0 * y0 + q->d * x + q->e * y0 + q->f;
    int64_t across = a * (2 * x + 1) + b * y0 + q->d; /* D at x */
    int64_t down = c * (2 * y0 + 1) + b * x + q->e;   /* F(x, y + 1) - F(x, y) */
    struct etch_run_band band;

    etch_run_band_init(&band, surface, paint);
    for (int16_t y = clip.y0; y < clip.y1; y++) {
        scan(&band, y, clip.x0, clip.x1, f, across, a);
        etch_run_band_row(&band, y);
        f += down;
        down += 2 * c;
        across += b;
    }
    etch_run_band_flush(&band);
}
