/* fragment/inverse_rows.h: the loops of depth in a floating layout; no part of the API. See
 * inverse.h.
 *
 * The plane walks as p = q 2^up + 2^15. Its error is below 2^15, so it never passes below 0; and q
 * is at most 2^32 - 2^20, so with half a step it does not pass 2^32. While p stays in one octave,
 * 2^f <= p - 2^15 < 2^(f + 1), the code is a sum, a shift and a difference away; where it leaves
 * it, at most once in an octave along a run, the four numbers for that are worked out again.
 */
#ifndef ETCH_FRAGMENT_INVERSE_ROWS_H
#define ETCH_FRAGMENT_INVERSE_ROWS_H

#include "depth_rows.h"
#include "inverse.h"

#define INVERSE_BIAS UINT32_C(0x8000)

/* stored = top - ((p + add) >> shift), for p - first < span */
struct inverse_octave {
    uint32_t first, span, add, top;
    uint8_t shift;
};

static ETCH_COLD struct inverse_octave inverse_octave(uint32_t p, uint8_t up)
{
    const uint32_t q = p > INVERSE_BIAS ? p - INVERSE_BIAS : 0;
    const uint8_t f = (uint8_t)(31 - (q != 0 ? etch_leading_zeros(q) : 31));

    if (q == 0 || f < up) /* below 2^-16 */
        return (struct inverse_octave){p, 1, 0, 65535 + (p >> 31), 31};
    const uint32_t top = 65535 + 2048 - (uint32_t)(f - up) * 2048;

    if (f <= 11) /* a pixel alone, without a rest */
        return (struct inverse_octave){p, 1, 0, top - (q << (11 - f)) + (p >> 31), 31};
    return (struct inverse_octave){(UINT32_C(1) << f) + INVERSE_BIAS, UINT32_C(1) << f,
                                   etch_wrap_sub(UINT32_C(1) << (f - 12), INVERSE_BIAS), top,
                                   (uint8_t)(f - 11)};
}

/* One run; the first pixel's depth is stored at `stored`. */
ETCH_INLINE void inverse_run(uint16_t *stored, uintptr_t to_pixel, const struct etch_run *run,
                             int16_t y, const struct etch_paint *paint, uint8_t up, etch_span *span,
                             etch_depth_test *passes)
{
    const struct etch_plane *const plane = &((const struct etch_depth_paint *)paint)->z;
    const uint32_t dp = plane->dx;
    uint32_t p = etch_plane_at(plane, run->x0, y), passed = 0;
    struct inverse_octave octave = {0, 0, 0, 0, 0};

    for (int32_t x = run->x0; x < run->x1; x++, stored++, p = etch_wrap_add(p, dp)) {
        if (etch_wrap_sub(p, octave.first) >= octave.span)
            octave = inverse_octave(p, up);
        const uint16_t depth = (uint16_t)(octave.top -
                                          (etch_wrap_add(p, octave.add) >> octave.shift));

        if (passes(depth, *stored)) {
            *stored = depth;
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

typedef void etch_inverse_rows(const struct etch_surface *surface, int16_t y0,
                               const struct etch_run *runs, uint8_t n,
                               const struct etch_paint *paint, uint8_t up, etch_span *span);
etch_inverse_rows etch_inverse_rows_less, etch_inverse_rows_lequal;

ETCH_INLINE void inverse_rows(const struct etch_surface *s, int16_t y0, const struct etch_run *runs,
                              uint8_t n, const struct etch_paint *paint, uint8_t up,
                              etch_span *span, etch_depth_test *passes)
{
    const uintptr_t to_pixel = etch_wrap_address_sub((uintptr_t)s->pixels, (uintptr_t)s->depth);

    ETCH_ASSERT(s->depth != NULL);
    for (uint8_t i = 0; i < n; i++, y0++) {
        uint16_t *const stored = (uint16_t *)etch_wrap_address_add(
            etch_surface_row(s, s->depth, y0), (uintptr_t)(uint16_t)runs[i].x0 * 2);

        inverse_run(stored, to_pixel, &runs[i], y0, paint, up, span, passes);
    }
}

#endif
