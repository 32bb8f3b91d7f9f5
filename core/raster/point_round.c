/* raster/point_round.c: round points to runs. Called by draw/ and applications. See point_runs.h.
 *
 * In 1/512 px the radius is the size, and the centre of pixel i at 512 i + 256. With dy from the
 * point's centre to a row's, a centre dx away is covered iff |dx| <= floor(sqrt(size^2 - dy^2)),
 * of at most 32 bits. */
#include "point_runs.h"

/* floor and ceil of (c - 256) / 512: the last pixel whose centre is at most c, the first at least.
 * |c| <= 2^24 + 2^16. */
static int32_t last_centre(int32_t c_q9)
{
    return (c_q9 - 256) >> 9;
}

static int32_t first_centre(int32_t c_q9)
{
    return (c_q9 + 255) >> 9;
}

static struct etch_run row(const struct etch_rect *clip, int32_t x, int32_t half)
{
    const int32_t from = first_centre(x - half), to = last_centre(x + half) + 1;
    const int32_t x0 = from < clip->x0 ? clip->x0 : from > clip->x1 ? clip->x1 : from;
    const int32_t x1 = to < x0 ? x0 : to > clip->x1 ? clip->x1 : to;
    const struct etch_run r = {(int16_t)x0, (int16_t)x1};

    return r;
}

void etch_point_runs_round(const struct etch_surface *surface, int32_t x_q8, int32_t y_q8,
                           uint16_t size_q8, const struct etch_paint *paint)
{
    const struct etch_rect *const clip = &surface->clip;
    const int32_t size = size_q8, x = 2 * x_q8, y = 2 * y_q8;
    const int32_t top = first_centre(y - size), bottom = last_centre(y + size) + 1;
    const int32_t end = bottom < clip->y1 ? bottom : clip->y1;
    struct etch_run runs[ETCH_RUN_BLOCK];

    if (first_centre(x - size) >= clip->x1 || last_centre(x + size) < clip->x0)
        return;
    for (int32_t at = top > clip->y0 ? top : clip->y0; at < end;) {
        const int16_t y0 = (int16_t)at;
        uint8_t n = 0;

        for (; at < end && n < ETCH_RUN_BLOCK; at++, n++) {
            const int32_t down = 512 * at + 256 - y; /* |down| <= size */
            const uint32_t dy = (uint32_t)(down < 0 ? -down : down);
            const uint32_t d = (uint32_t)size * (uint32_t)size - dy * dy;

            runs[n] = row(clip, x, (int32_t)etch_sqrt_u32(d));
        }
        paint->kernel(surface, y0, runs, n, paint);
    }
}
