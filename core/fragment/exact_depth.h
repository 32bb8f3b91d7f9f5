/* fragment/exact_depth.h: the loop of exact depths; no part of the API. See exact.h.
 *
 * A depth plane from raster/basis.h is within 512 units of 2^-16 for cutting its slopes off, 512
 * for rounding them, 256 for dropped bits and 32 for the reciprocal; one from raster/plane.h within
 * (x + y + 1) / 2. `slack` is above both, all over the run. The plane walks with that added, so the
 * true value is at most z and above z - 2 slack.
 */
#ifndef ETCH_FRAGMENT_EXACT_DEPTH_H
#define ETCH_FRAGMENT_EXACT_DEPTH_H

#include "exact.h"

/* At most 32768 for x1 = y + 1 = 32767. */
ETCH_INLINE uint32_t exact_slack(int16_t x1, int16_t y)
{
    const uint32_t far = ((uint32_t)(uint16_t)x1 + (uint16_t)y) / 2 + 1;

    return far < 1536 ? 1536 : far;
}

/* The depth at (x, y), where z is so close to the integer k in its upper half that the true value
 * may be below it. That is 0.5 .. 65535.5: so if k is 0, z is above 0.5 or past 65536 and then,
 * since 2 slack <= 1, below 0.5. The true value less the plane's, times D, is below 2^63, and so is
 * k less the plane's: the two are compared. */
static ETCH_COLD uint16_t exact_depth(const struct etch_exact_depth *exact, uint32_t z, int16_t x,
                                      int16_t y, uint32_t slack)
{
    const uint32_t k = z >> 16, plane = etch_wrap_sub(z, slack);
    const int32_t up = (int32_t)slack - (int32_t)(z & 0xFFFF); /* from the plane to k */

    if (k == 0)
        return z < 0x8000 ? UINT16_MAX : 0;
    const int64_t above = etch_exact_above(&exact->n, x, y, etch_wrap_mul_u64(exact->area, plane));

    return (uint16_t)(k - (above < (int64_t)exact->area * up ? 1 : 0));
}

/* One run; the first pixel's depth is stored at `stored`. */
ETCH_INLINE void exact_depth_run(uint16_t *stored, uintptr_t to_pixel, const struct etch_run *run,
                                 int16_t y, const struct etch_paint *paint,
                                 const struct etch_exact_depth *exact, etch_span *span,
                                 etch_depth_test *passes)
{
    const struct etch_plane *const plane = &((const struct etch_depth_paint *)paint)->z;
    const uint32_t dz = plane->dx, slack = exact_slack(run->x1, y), close = 2 * slack;
    uint32_t z = etch_wrap_add(etch_plane_at(plane, run->x0, y), slack), passed = 0;

    for (int32_t x = run->x0; x < run->x1; x++, stored++, z = etch_wrap_add(z, dz)) {
        uint32_t depth = z >> 16;

        if ((z & 0xFFFF) < close)
            depth = exact_depth(exact, z, (int16_t)x, y, slack);
        if (passes((uint16_t)depth, *stored)) {
            *stored = (uint16_t)depth;
            passed++;
        } else if (passed != 0) {
            span((uint16_t *)etch_wrap_address_add((uintptr_t)(stored - passed), to_pixel),
                 x - (int32_t)passed, passed, y, paint);
            passed = 0;
        }
    }
    if (passed != 0)
        span((uint16_t *)etch_wrap_address_add((uintptr_t)(stored - passed), to_pixel),
             run->x1 - (int32_t)passed, passed, y, paint);
}

ETCH_INLINE void exact_depth_rows(const struct etch_surface *s, int16_t y0,
                                  const struct etch_run *runs, uint8_t n,
                                  const struct etch_paint *paint,
                                  const struct etch_exact_depth *exact, etch_span *span,
                                  etch_depth_test *passes)
{
    const uintptr_t to_pixel = etch_wrap_address_sub((uintptr_t)s->pixels, (uintptr_t)s->depth);

    ETCH_ASSERT(s->depth != NULL);
    for (uint8_t i = 0; i < n; i++, y0++) {
        uint16_t *const stored = (uint16_t *)etch_wrap_address_add(
            etch_surface_row(s, s->depth, y0), (uintptr_t)(uint16_t)runs[i].x0 * 2);

        exact_depth_run(stored, to_pixel, &runs[i], y0, paint, exact, span, passes);
    }
}

#endif
