/* fragment/dither_rows.h: the loop of dithered colours; no part of the API. See dither.h.
 *
 * Planes of gouraud.h have 1/2 added, for rounding. It is taken off where a span starts, and a
 * threshold put in at every pixel: value + t is between 1/128 - 1/510 > 0 and 31 + 127/128 + 1/510
 * < 32, so nothing wraps.
 */
#ifndef ETCH_FRAGMENT_DITHER_ROWS_H
#define ETCH_FRAGMENT_DITHER_ROWS_H

#include "dither.h"
#include "gouraud_rows.h"

ETCH_INLINE void dither_span(uint16_t *pixel, int32_t x, uint32_t n, int32_t y,
                             const struct etch_gouraud_paint *p, etch_gouraud_pack *pack)
{
    const uint8_t *const thresholds = etch_dither_bayer[y & 7];
    const uint16_t *const end = pixel + n;
    const uint32_t dr = p->r.dx, dg = p->g.dx, db = p->b.dx;
    uint32_t r = etch_wrap_sub(etch_plane_at(&p->r, (int16_t)x, (int16_t)y), UINT32_C(1) << 26);
    uint32_t g = etch_wrap_sub(etch_plane_at(&p->g, (int16_t)x, (int16_t)y), UINT32_C(1) << 25);
    uint32_t b = etch_wrap_sub(etch_plane_at(&p->b, (int16_t)x, (int16_t)y), UINT32_C(1) << 26);
    uint32_t column = (uint32_t)x;

    do {
        const uint32_t fine = (uint32_t)thresholds[column & 7] << 19, coarse = fine << 1;

        *pixel++ = pack(etch_wrap_add(r, coarse), etch_wrap_add(g, fine), etch_wrap_add(b, coarse));
        r = etch_wrap_add(r, dr), g = etch_wrap_add(g, dg), b = etch_wrap_add(b, db);
        column++;
    } while (pixel != end);
}

#endif
