/* raster/smooth_shapes.h: smooth discs, rings, arcs, rounded rectangles and lines, without memory
 * for edges.
 *
 *      static int16_t cover[320 + 1];
 *      const struct etch_cover_flat_paint red = {{etch_cover_flat}, etch_rgb565(230, 60, 50), 255};
 *
 *      etch_smooth_arc(surface, etch_pixel_q8(120, 160), 90 * 256, 70 * 256, 24576, 30000,
 *                      &red.paint, cover);
 *
 * A row of pixels is cut by 16 lines, as in smooth.h, and on each the shape is one to three
 * intervals whose ends are worked out from its equation, to 1/256 px, rounded down. The cover of a
 * pixel differs from the true area by 1/32 at most for each edge in it that is nearly level and
 * 1/256 + 1/512 for each that is steep: by less than 1/16, unless more than two level edges share a
 * pixel, as in a frame of less than a pixel. Strips and clips change nothing; what meets itself is
 * counted once.
 *
 * No seams: shapes with a circle, a ray or a side in common have the same ends there, so their
 * covers add up to exactly 4096. Blended one after the other, though, what is below both would show
 * through at such an edge. So let each shape reach a pixel or two under the one that is drawn after
 * it: then only the later one's edge shows, and its pixels are the mixture of the two colours,
 * rounded once.
 *
 * All lengths and places in 1/256 px, places -2^23 .. 2^23, where 0 is the edge of pixel 0 and 128
 * its middle. The disc of etch_circle_fill(x, y, r) is about etch_smooth_disc(etch_pixel_q8(x, y),
 * 256 r + 128). `cover` is the caller's for the call: as many elements as the clip is wide, and
 * one. Nothing else is needed: a few hundred bytes of stack. Thick polylines with joints, dashes,
 * ellipses: outline.h, stroke.h with smooth.h.
 */
#ifndef ETCH_RASTER_SMOOTH_SHAPES_H
#define ETCH_RASTER_SMOOTH_SHAPES_H

#include "smooth.h"

/* The middle of a pixel. */
ETCH_INLINE struct etch_point_q8 etch_pixel_q8(int16_t x, int16_t y)
{
    const struct etch_point_q8 p = {x * INT32_C(256) + 128, y * INT32_C(256) + 128};

    return p;
}

/* Radii and widths up to 2^23; below 0 and what is empty covers nothing. A row takes 16 square
 * roots for each circle that it crosses. */
void etch_smooth_disc(const struct etch_surface *s, struct etch_point_q8 centre, int32_t r,
                      const struct etch_cover_paint *paint, int16_t *cover);

/* A circle of a line of this width, half to each side. */
void etch_smooth_circle(const struct etch_surface *s, struct etch_point_q8 centre, int32_t r,
                        int32_t width, const struct etch_cover_paint *paint, int16_t *cover);

/* The disc of radius `outer` less that of radius `inner`; inner <= 0 is the whole disc. */
void etch_smooth_ring(const struct etch_surface *s, struct etch_point_q8 centre, int32_t outer,
                      int32_t inner, const struct etch_cover_paint *paint, int16_t *cover);

/* The part of a ring, or of a disc, from the angle `from` on for `sweep` 65536ths of a turn
 * clockwise: 0 covers nothing, 65536 or more is all. Parts between the same rays have no seam. */
void etch_smooth_arc(const struct etch_surface *s, struct etch_point_q8 centre, int32_t outer,
                     int32_t inner, uint16_t from, uint32_t sweep,
                     const struct etch_cover_paint *paint, int16_t *cover);

/* The rectangle between two corners, its own rounded by r, at most half of either side. */
void etch_smooth_round_rect(const struct etch_surface *s, struct etch_point_q8 a,
                            struct etch_point_q8 b, int32_t r, const struct etch_cover_paint *paint,
                            int16_t *cover);

/* Its frame: less the rounded rectangle that is `width` smaller on each side, of radius r - width.
 */
void etch_smooth_round_frame(const struct etch_surface *s, struct etch_point_q8 a,
                             struct etch_point_q8 b, int32_t r, int32_t width,
                             const struct etch_cover_paint *paint, int16_t *cover);

/* The straight line of a width of 2 .. 2^15, with ends cut square at a and b (256 is one pixel);
 * places -2^22 .. 2^22. A line of no length covers nothing. */
void etch_smooth_line(const struct etch_surface *s, struct etch_point_q8 a, struct etch_point_q8 b,
                      int32_t width, const struct etch_cover_paint *paint, int16_t *cover);

/* The same with round ends, counted once where they meet the line; of no length it is a disc. */
void etch_smooth_line_round(const struct etch_surface *s, struct etch_point_q8 a,
                            struct etch_point_q8 b, int32_t width,
                            const struct etch_cover_paint *paint, int16_t *cover);

/* The polygon v[0] .. v[n - 1] by the non-zero rule, over the caller's n edges, of which those
 * beside the clip's rows are not used. ETCH_ENOMEM, and nothing drawn, if `room` is too few. */
enum etch_status etch_smooth_polygon(const struct etch_surface *s, const struct etch_point_q8 *v,
                                     uint16_t n, struct etch_smooth_edge *edge, uint16_t room,
                                     const struct etch_cover_paint *paint, int16_t *cover);

#endif
