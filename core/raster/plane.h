/* raster/plane.h: part two of triangle set-up, the plane equation of a varying.
 *
 * Precise mode. `origin`, `dx` and `dy` are the exact rationals rounded to the nearest unit,
 * for every triangle wherever its vertices are, anchored at frame pixel (0, 0): the value at
 * pixel (x, y) of the triangle errs by at most (x + y + 1) / 2 units. Equal values at the
 * three vertices give exactly that value everywhere.
 */
#ifndef ETCH_RASTER_PLANE_H
#define ETCH_RASTER_PLANE_H

#include "../base/sink.h"
#include "triangle.h"

/* The plane through value[i] at the caller's vertex i of `t`; values are unsigned 32-bit in
 * any format (bias signed ones by 2^31 and take it off again afterwards). */
void etch_plane_setup(struct etch_plane *plane, const struct etch_triangle *t,
                      const uint32_t value[3]);

/* Formats of the shipped kernels. One half is added at set-up, so that a kernel rounds to
 * nearest by truncation. */

/* 8-bit channel to 5.27 (red, blue): round(c * 31 * 2^27 / 255) + 1/2. Fits: at most 31.5. */
uint32_t etch_channel_q27(uint8_t c);

/* 8-bit channel to 6.26 (green): round(c * 63 * 2^26 / 255) + 1/2. */
uint32_t etch_channel_q26(uint8_t c);

/* Depth 16.16 to its plane format, 16.16 + 1/2; above 65535.0 counts as 65535.0. */
ETCH_INLINE uint32_t etch_depth_q16(uint32_t z_q16)
{
    return (z_q16 > UINT32_C(0xFFFF0000) ? UINT32_C(0xFFFF0000) : z_q16) + 0x8000;
}

/* The exact planes of the colours, and of the depths, of the caller's vertices. */
void etch_plane_color(const struct etch_triangle *t, const struct etch_vertex *const v[3],
                      struct etch_plane *red, struct etch_plane *green, struct etch_plane *blue);
void etch_plane_depth(const struct etch_triangle *t, const struct etch_vertex *const v[3],
                      struct etch_plane *z);

#endif
