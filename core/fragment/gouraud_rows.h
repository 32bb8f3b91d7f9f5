/* fragment/gouraud_rows.h: the loop of the two Gouraud kernels without depth; no part of the API.
 *
 * The three planes walk along the runs as one cursor. From the end of a run to the beginning of
 * the next it moves one row down and some columns left or right, which is exact in arithmetic
 * modulo 2^32: the value at a pixel is that of etch_plane_at whatever way led there.
 */
#ifndef ETCH_FRAGMENT_GOURAUD_ROWS_H
#define ETCH_FRAGMENT_GOURAUD_ROWS_H

#include "../base/rgb565.h"
#include "gouraud.h"

/* 5.27, 6.26 and 5.27 to a pixel: the integer bits are the channel. */
typedef uint16_t etch_gouraud_pack(uint32_t r, uint32_t g, uint32_t b);

ETCH_INLINE uint16_t gouraud_pack(uint32_t r, uint32_t g, uint32_t b)
{
    return (uint16_t)((r >> 27 << 6 | g >> 26) << 5 | b >> 27);
}

ETCH_INLINE uint16_t gouraud_pack_swapped(uint32_t r, uint32_t g, uint32_t b)
{
    return etch_rgb565_swap(gouraud_pack(r, g, b));
}

/* Where the three planes stand. */
struct gouraud_cursor {
    uint32_t r, g, b;
};

/* The pixels from `pixel` to `stop`; c follows. */
ETCH_INLINE struct gouraud_cursor gouraud_walk(uint16_t *pixel, const uint16_t *stop,
                                               struct gouraud_cursor c,
                                               const struct etch_gouraud_paint *p,
                                               etch_gouraud_pack *pack)
{
    const uint32_t dr = p->r.dx, dg = p->g.dx, db = p->b.dx;
    uint32_t r = c.r, g = c.g, b = c.b;

    if (((stop - pixel) & 1) != 0) {
        *pixel++ = pack(r, g, b);
        r = etch_wrap_add(r, dr), g = etch_wrap_add(g, dg), b = etch_wrap_add(b, db);
    }
    while (pixel != stop) {
        pixel[0] = pack(r, g, b);
        r = etch_wrap_add(r, dr), g = etch_wrap_add(g, dg), b = etch_wrap_add(b, db);
        ETCH_KEEP(r);
        ETCH_KEEP(g);
        ETCH_KEEP(b);
        pixel[1] = pack(r, g, b);
        r = etch_wrap_add(r, dr), g = etch_wrap_add(g, dg), b = etch_wrap_add(b, db);
        pixel += 2;
    }
    return (struct gouraud_cursor){r, g, b};
}

ETCH_INLINE void gouraud_span(uint16_t *pixel, int32_t x, uint32_t n, int32_t y,
                              const struct etch_gouraud_paint *p, etch_gouraud_pack *pack)
{
    const struct gouraud_cursor c = {etch_plane_at(&p->r, (int16_t)x, (int16_t)y),
                                     etch_plane_at(&p->g, (int16_t)x, (int16_t)y),
                                     etch_plane_at(&p->b, (int16_t)x, (int16_t)y)};

    gouraud_walk(pixel, pixel + n, c, p, pack);
}

ETCH_INLINE void gouraud_rows(const struct etch_surface *s, int16_t y0, const struct etch_run *runs,
                              uint8_t n, const struct etch_gouraud_paint *p,
                              etch_gouraud_pack *pack)
{
    const struct etch_run *const end = runs + n;
    const uintptr_t stride = (uintptr_t)s->stride * 2;
    uintptr_t row = etch_surface_row(s, s->pixels, y0);
    const uint32_t dr = p->r.dx, dg = p->g.dx, db = p->b.dx;
    uint32_t r = etch_plane_at(&p->r, 0, y0), g = etch_plane_at(&p->g, 0, y0);
    uint32_t b = etch_plane_at(&p->b, 0, y0), x = 0;

    do {
        const uint32_t x0 = (uint16_t)runs->x0, x1 = (uint16_t)runs->x1;
        const uint32_t right = etch_wrap_sub(x0, x);
        uint16_t *pixel = (uint16_t *)etch_wrap_address_add(row, (uintptr_t)x0 * 2);
        const uint16_t *const stop = (uint16_t *)etch_wrap_address_add(row, (uintptr_t)x1 * 2);

        r = etch_wrap_add(r, etch_wrap_mul(right, dr));
        g = etch_wrap_add(g, etch_wrap_mul(right, dg));
        b = etch_wrap_add(b, etch_wrap_mul(right, db));
        if (etch_wrap_mul(x0 ^ x1, UINT32_C(1) << 31) != 0) { /* for `& 1` gcc loads both again */
            *pixel++ = pack(r, g, b);
            r = etch_wrap_add(r, dr), g = etch_wrap_add(g, dg), b = etch_wrap_add(b, db);
        }
        while (pixel != stop) {
            pixel[0] = pack(r, g, b);
            r = etch_wrap_add(r, dr), g = etch_wrap_add(g, dg), b = etch_wrap_add(b, db);
            ETCH_KEEP(r);
            ETCH_KEEP(g);
            ETCH_KEEP(b);
            pixel[1] = pack(r, g, b);
            r = etch_wrap_add(r, dr), g = etch_wrap_add(g, dg), b = etch_wrap_add(b, db);
            pixel += 2;
        }
        r = etch_wrap_add(r, p->r.dy), g = etch_wrap_add(g, p->g.dy);
        b = etch_wrap_add(b, p->b.dy);
        x = x1, row += stride;
    } while (++runs != end);
}

/* Cortex-M0+ (W8, W9): 12.5 instructions a pixel, 60 a run. ETCH_KEEP saves 3 a pixel: without it
 * gcc adds twice the step to the first value and spills. */

#endif
