/* leaf/vector128/narrow_rows.h: interpolated colour with depth where runs are short; no part of the
 * API. See fragment/gouraud_narrow.h.
 *
 * Depth and colour of a pixel are the lanes of one vector, which one sum takes a column further.
 */
#ifndef ETCH_LEAF_NARROW_ROWS_H
#define ETCH_LEAF_NARROW_ROWS_H

#include "../../fragment/gouraud_narrow.h"
#include "gouraud_planes.h"

/* The pixel of lanes z, r, g, b. Two forms. On SSE2 6 bits of each lane are left, the last one of
 * red and blue is cleared, and products of 16 bits whose neighbours are summed make twice the
 * pixel: 2048 r + 64 g + b, below 2^17. */
#if defined(__SSE2__)
ETCH_INLINE uint16_t narrow_pixel(vector_u32 v)
{
    const vector_s32 six = (vector_s32)(v >> 26 & (vector_u32){0, 62, 63, 62});
    const vector_s16 lanes = __builtin_ia32_packssdw128(six, six);
    const vector_s16 factors = {0, 2048, 64, 1, 0, 0, 0, 0};
    const uint64_t sums = ((vector_u64)__builtin_ia32_pmaddwd128(lanes, factors))[0];

    return (uint16_t)(((sums >> 32) + (sums & UINT32_MAX)) >> 1);
}
#else
ETCH_INLINE uint16_t narrow_pixel(vector_u32 v)
{
    return gouraud_pack(v[1], v[2], v[3]);
}
#endif

/* A pixel in the surface's byte order. */
typedef uint16_t narrow_order(uint16_t pixel);

ETCH_INLINE uint16_t narrow_plain(uint16_t pixel)
{
    return pixel;
}

ETCH_INLINE void narrow_rows(const struct etch_surface *s, int16_t y0, const struct etch_run *runs,
                             uint8_t n, const struct etch_gouraud_paint *p, etch_depth_test *passes,
                             narrow_order *order)
{
    const struct etch_run *const end = runs + n;
    struct gouraud_planes planes = gouraud_planes(p, y0);
    const uintptr_t stride = (uintptr_t)s->stride * 2;
    const uintptr_t to_pixel = etch_wrap_address_sub((uintptr_t)s->pixels, (uintptr_t)s->depth);
    uintptr_t row = etch_surface_row(s, s->depth, y0);

    ETCH_ASSERT(s->depth != NULL);
    for (; runs != end; runs++) {
        const uint32_t x0 = (uint16_t)runs->x0, x1 = (uint16_t)runs->x1;

        if (x0 != x1) {
            uintptr_t at = etch_wrap_address_add(row, (uintptr_t)x0 * 2);
            const uintptr_t stop = etch_wrap_address_add(row, (uintptr_t)x1 * 2);
            vector_u32 v = gouraud_planes_at(&planes, x0);

            do {
                const uint16_t depth = (uint16_t)(v[0] >> 16);

                if (passes(depth, *(const uint16_t *)at)) {
                    *(uint16_t *)at = depth;
                    *(uint16_t *)etch_wrap_address_add(at, to_pixel) = order(narrow_pixel(v));
                }
                v += planes.dx;
                at += 2;
            } while (at != stop);
        }
        planes.left += planes.dy;
        row = etch_wrap_address_add(row, stride);
    }
}

#endif
