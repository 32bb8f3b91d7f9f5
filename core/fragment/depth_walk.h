/* fragment/depth_walk.h: the loops behind depth_rows.h; no part of the API. */
#ifndef ETCH_FRAGMENT_DEPTH_WALK_H
#define ETCH_FRAGMENT_DEPTH_WALK_H

#include "depth_rows.h"

/* Writes depths while they pass, from `stored` on, which passes; returns the first that does not,
 * or end; *z follows. */
ETCH_INLINE uint16_t *depth_write(uint16_t *stored, const uint16_t *end, uint32_t *z, uint32_t dz,
                                  etch_depth_test *passes)
{
    uint32_t depth = *z;

    do {
        *stored = (uint16_t)(depth >> 16);
        depth = etch_wrap_add(depth, dz);
        stored++;
    } while (stored != end && passes((uint16_t)(depth >> 16), *stored));
    *z = depth;
    return stored;
}

ETCH_INLINE void depth_rows(const struct etch_surface *s, int16_t y0, const struct etch_run *runs,
                            uint8_t n, const struct etch_paint *paint, etch_span *span,
                            etch_depth_test *passes)
{
    const struct etch_plane *const plane = &((const struct etch_depth_paint *)paint)->z;
    const struct etch_run *const last = runs + n;
    const uintptr_t stride = (uintptr_t)s->stride * 2;
    const uintptr_t to_pixel = etch_wrap_address_sub((uintptr_t)s->pixels, (uintptr_t)s->depth);
    uintptr_t row = etch_surface_row(s, s->depth, y0);

    ETCH_ASSERT(s->depth != NULL);
    for (int16_t y = y0; runs != last; runs++, y++, row = etch_wrap_address_add(row, stride)) {
        uint16_t *stored = (uint16_t *)etch_wrap_address_add(row, (uintptr_t)runs->x0 * 2);
        const uint16_t *const end = stored + (runs->x1 - runs->x0);
        uint32_t z = etch_plane_at(plane, runs->x0, y);

        while ((stored = etch_depth_scan(stored, end, &z, plane->dx, passes)) != end) {
            uint16_t *const first = stored;

            stored = depth_write(stored, end, &z, plane->dx, passes);
            span((uint16_t *)etch_wrap_address_add((uintptr_t)first, to_pixel),
                 (int32_t)(runs->x1 - (end - first)), (uint32_t)(stored - first), y, paint);
        }
    }
}

#endif
