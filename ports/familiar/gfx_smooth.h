/* ports/familiar/gfx_smooth.h: TFT_eSPI's smooth shapes. They are blended with what is there, so
 * a background colour is not asked for. `cover` is the caller's: as many elements as the frame
 * is wide, and one. See gfx.h. */
#ifndef ETCH_PORTS_FAMILIAR_GFX_SMOOTH_H
#define ETCH_PORTS_FAMILIAR_GFX_SMOOTH_H

#include "gfx.h"

#ifdef __cplusplus
extern "C" {
#endif

#include "../../core/fragment/cover.h"
#include "../../core/raster/smooth_shapes.h"

ETCH_INLINE struct etch_cover_flat_paint gfx_cover(const struct gfx *g, uint16_t color)
{
    struct etch_cover_flat_paint paint;

    paint.paint.kernel = g->swapped ? etch_cover_flat_swapped : etch_cover_flat;
    paint.color = color;
    paint.opacity = 255;
    return paint;
}

/* 2 r + 1 pixels wide. */
ETCH_INLINE void gfx_fillSmoothCircle(struct gfx *g, int16_t x, int16_t y, int16_t r,
                                      uint16_t color, int16_t *cover)
{
    const struct etch_cover_flat_paint paint = gfx_cover(g, color);

    etch_smooth_disc(&g->surface, etch_pixel_q8(x, y), r * INT32_C(256) + 128, &paint.paint, cover);
}

/* A line of one pixel round a middle, r pixels from it. */
ETCH_INLINE void gfx_drawSmoothCircle(struct gfx *g, int16_t x, int16_t y, int16_t r,
                                      uint16_t color, int16_t *cover)
{
    const struct etch_cover_flat_paint paint = gfx_cover(g, color);

    etch_smooth_circle(&g->surface, etch_pixel_q8(x, y), r * INT32_C(256), 256, &paint.paint,
                       cover);
}

/* From the middle of pixel (ax, ay) to that of (bx, by), ends round; `wide_q8` in 1/256 px. */
ETCH_INLINE void gfx_drawWideLine(struct gfx *g, int16_t ax, int16_t ay, int16_t bx, int16_t by,
                                  int32_t wide_q8, uint16_t color, int16_t *cover)
{
    const struct etch_cover_flat_paint paint = gfx_cover(g, color);

    etch_smooth_line_round(&g->surface, etch_pixel_q8(ax, ay), etch_pixel_q8(bx, by), wide_q8,
                           &paint.paint, cover);
}

/* Degrees to 65536ths of a turn, rounded to nearest. */
ETCH_INLINE uint32_t gfx_angle(uint16_t degrees)
{
    return ((degrees < 360 ? degrees : 360U) * UINT32_C(8192) + 22) / 45;
}

/* The ring of the radii `inner` .. `outer`, both drawn, between two angles of 0 .. 360 degrees,
 * clockwise from the bottom: 90 is left. An end before the start goes over the bottom; equal
 * ones draw nothing. */
ETCH_INLINE void gfx_drawArc(struct gfx *g, int16_t x, int16_t y, int16_t outer, int16_t inner,
                             uint16_t start, uint16_t end, uint16_t color, int16_t *cover)
{
    const struct etch_cover_flat_paint paint = gfx_cover(g, color);
    const uint32_t from = gfx_angle(start), to = gfx_angle(end);
    const uint32_t sweep = to < from ? 65536 - (from - to) : to - from;

    etch_smooth_arc(&g->surface, etch_pixel_q8(x, y), outer * INT32_C(256) + 128,
                    inner * INT32_C(256) - 128, (uint16_t)(from + 16384), sweep, &paint.paint,
                    cover);
}

/* Corners are held to 32767. */
ETCH_INLINE void gfx_fillSmoothRoundRect(struct gfx *g, int16_t x, int16_t y, int16_t w, int16_t h,
                                         int16_t r, uint16_t color, int16_t *cover)
{
    const struct etch_cover_flat_paint paint = gfx_cover(g, color);
    const struct etch_rect all = etch_rect_from_size(x, y, w, h);
    const struct etch_point_q8 a = {all.x0 * INT32_C(256), all.y0 * INT32_C(256)};
    const struct etch_point_q8 b = {all.x1 * INT32_C(256), all.y1 * INT32_C(256)};

    if (w > 0 && h > 0)
        etch_smooth_round_rect(&g->surface, a, b, r * INT32_C(256), &paint.paint, cover);
}

#ifdef __cplusplus
}
#endif

#endif
