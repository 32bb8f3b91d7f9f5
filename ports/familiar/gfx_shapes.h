/* ports/familiar/gfx_shapes.h: circles, rounded rectangles, triangles and ellipses under
 * familiar names. See gfx.h. */
#ifndef ETCH_PORTS_FAMILIAR_GFX_SHAPES_H
#define ETCH_PORTS_FAMILIAR_GFX_SHAPES_H

#include "gfx.h"

#ifdef __cplusplus
extern "C" {
#endif

#include "../../core/draw/round.h"
#include "../../core/raster/circle.h"

/* 2 r + 1 pixels wide, its middle is pixel (x, y); r = 0 is that pixel. */
ETCH_INLINE void gfx_drawCircle(struct gfx *g, int16_t x, int16_t y, int16_t r, uint16_t color)
{
    etch_circle_draw(&g->surface, x, y, r, gfx_stored(g, color));
}

/* All on and inside that circle. */
ETCH_INLINE void gfx_fillCircle(struct gfx *g, int16_t x, int16_t y, int16_t r, uint16_t color)
{
    etch_circle_fill(&g->surface, x, y, r, gfx_stored(g, color));
}

/* 2 rx + 1 pixels wide and 2 ry + 1 high. */
ETCH_INLINE void gfx_drawEllipse(struct gfx *g, int16_t x, int16_t y, int16_t rx, int16_t ry,
                                 uint16_t color)
{
    etch_ellipse_draw(&g->surface, x, y, rx, ry, gfx_stored(g, color));
}

ETCH_INLINE void gfx_fillEllipse(struct gfx *g, int16_t x, int16_t y, int16_t rx, int16_t ry,
                                 uint16_t color)
{
    etch_ellipse_fill(&g->surface, x, y, rx, ry, gfx_stored(g, color));
}

/* ---- rounded rectangles
 * ------------------------------------------------------------------------ */

typedef void gfx_round(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t r,
                       uint16_t color);

/* The part of a circle or disc inside `area`. Where its middle is beyond 32767, the frame is
 * moved by r for the call, which what is left of it here has room for. */
ETCH_INLINE void gfx_corner(const struct gfx *g, struct etch_rect area, int32_t cx, int32_t cy,
                            int16_t r, uint16_t color, gfx_round *draw)
{
    struct etch_surface part = gfx_part(g, area);
    const int16_t dx = cx > INT16_MAX ? r : 0, dy = cy > INT16_MAX ? r : 0;

    if (etch_rect_is_empty(part.clip))
        return;
    part.pixels += etch_surface_index(&part, part.clip.x0, part.clip.y0);
    part.clip = gfx_area(part.clip.x0 - dx, part.clip.y0 - dy, part.clip.x1 - dx,
                         part.clip.y1 - dy);
    part.window = part.clip;
    part.depth = NULL;
    part.stencil = NULL;
    draw(&part, (int16_t)(cx - dx), (int16_t)(cy - dy), r, gfx_stored(g, color));
}

/* All four corners, each up to its circle's middle row and column, which are left out. */
ETCH_INLINE void gfx_corners(const struct gfx *g, int16_t x, int16_t y, int16_t w, int16_t h,
                             int16_t r, uint16_t color, gfx_round *draw)
{
    const int32_t x1 = (int32_t)x + w, y1 = (int32_t)y + h;
    const int32_t left = (int32_t)x + r, top = (int32_t)y + r; /* middles */
    const int32_t right = x1 - r - 1, bottom = y1 - r - 1;

    gfx_corner(g, gfx_area(x, y, left, top), left, top, r, color, draw);
    gfx_corner(g, gfx_area(right + 1, y, x1, top), right, top, r, color, draw);
    gfx_corner(g, gfx_area(x, bottom + 1, left, y1), left, bottom, r, color, draw);
    gfx_corner(g, gfx_area(right + 1, bottom + 1, x1, y1), right, bottom, r, color, draw);
}

/* A radius below 0 is 0, one above half of the shorter side is that half. */
ETCH_INLINE int16_t gfx_radius(int16_t w, int16_t h, int16_t r)
{
    const int16_t most = (int16_t)((w < h ? w : h) / 2);

    return (int16_t)(r < 0 ? 0 : r > most ? most : r);
}

/* Corners are quarters of gfx_drawCircle, whose middles are r pixels inside. */
ETCH_INLINE void gfx_drawRoundRect(struct gfx *g, int16_t x, int16_t y, int16_t w, int16_t h,
                                   int16_t r, uint16_t color)
{
    const int32_t x1 = (int32_t)x + w, y1 = (int32_t)y + h;

    if (w <= 0 || h <= 0)
        return;
    r = gfx_radius(w, h, r);
    gfx_fill(g, gfx_area((int32_t)x + r, y, x1 - r, (int32_t)y + 1), color);
    gfx_fill(g, gfx_area((int32_t)x + r, y1 - 1, x1 - r, y1), color);
    gfx_fill(g, gfx_area(x, (int32_t)y + r, (int32_t)x + 1, y1 - r), color);
    gfx_fill(g, gfx_area(x1 - 1, (int32_t)y + r, x1, y1 - r), color);
    gfx_corners(g, x, y, w, h, r, color, etch_circle_draw);
}

ETCH_INLINE void gfx_fillRoundRect(struct gfx *g, int16_t x, int16_t y, int16_t w, int16_t h,
                                   int16_t r, uint16_t color)
{
    const int32_t x1 = (int32_t)x + w, y1 = (int32_t)y + h;

    if (w <= 0 || h <= 0)
        return;
    r = gfx_radius(w, h, r);
    gfx_fill(g, gfx_area((int32_t)x + r, y, x1 - r, y1), color);
    gfx_fill(g, gfx_area(x, (int32_t)y + r, (int32_t)x + r, y1 - r), color);
    gfx_fill(g, gfx_area(x1 - r, (int32_t)y + r, x1, y1 - r), color);
    gfx_corners(g, x, y, w, h, r, color, etch_circle_fill);
}

/* ---- triangles
 * --------------------------------------------------------------------------------- */

/* Three lines, corners once. */
ETCH_INLINE void gfx_drawTriangle(struct gfx *g, int16_t x0, int16_t y0, int16_t x1, int16_t y1,
                                  int16_t x2, int16_t y2, uint16_t color)
{
    etch_triangle_draw(&g->surface, x0, y0, x1, y1, x2, y2, gfx_stored(g, color));
}

/* Where the edge from a to b, a above b, is on row y: rounded towards a. k < 2^16 rows down of
 * dy, so remainder k < 2^32. */
ETCH_INLINE int32_t gfx_edge(struct etch_point a, struct etch_point b, int32_t y)
{
    const int32_t dx = (int32_t)b.x - a.x;
    const uint32_t dy = (uint32_t)((int32_t)b.y - a.y), k = (uint32_t)(y - a.y);
    const uint32_t far = (uint32_t)(dx < 0 ? -dx : dx);
    const int32_t moved = (int32_t)(far / dy * k + far % dy * k / dy);

    return dx < 0 ? a.x - moved : a.x + moved;
}

ETCH_INLINE void gfx_row(const struct gfx *g, int32_t a, int32_t b, int32_t y, uint16_t color)
{
    gfx_fill(g, gfx_area(a < b ? a : b, y, (a < b ? b : a) + 1, y + 1), color);
}

/* From the upper to the lower of two corners, against the edge of all three; `last` may be left
 * out. */
ETCH_INLINE void gfx_half(const struct gfx *g, struct etch_point a, struct etch_point b,
                          struct etch_point top, struct etch_point low, int32_t last,
                          uint16_t color)
{
    const struct etch_rect clip = g->surface.clip;
    const int32_t end = last < clip.y1 ? last : clip.y1 - 1;

    for (int32_t y = a.y > clip.y0 ? a.y : clip.y0; y <= end; y++)
        gfx_row(g, gfx_edge(a, b, y), gfx_edge(top, low, y), y, color);
}

ETCH_INLINE void gfx_sort(struct etch_point *a, struct etch_point *b)
{
    const struct etch_point kept = *a;

    if (a->y > b->y) {
        *a = *b;
        *b = kept;
    }
}

/* Corners and edges belong to it: a row goes from one edge to the other, both ends drawn, where
 * an edge is rounded towards its upper end. For triangles that share edges use
 * etch_triangle_fill, which draws no pixel of two neighbours twice. */
ETCH_INLINE void gfx_fillTriangle(struct gfx *g, int16_t x0, int16_t y0, int16_t x1, int16_t y1,
                                  int16_t x2, int16_t y2, uint16_t color)
{
    struct etch_point a = {x0, y0}, b = {x1, y1}, c = {x2, y2};

    gfx_sort(&a, &b);
    gfx_sort(&b, &c);
    gfx_sort(&a, &b);
    if (a.y == c.y) {
        const int32_t ab = a.x < b.x ? a.x : b.x, most = a.x < b.x ? b.x : a.x;

        gfx_row(g, ab < c.x ? ab : c.x, most > c.x ? most : c.x, a.y, color);
        return;
    }
    if (a.y != b.y)
        gfx_half(g, a, b, a, c, b.y == c.y ? b.y : (int32_t)b.y - 1, color);
    if (b.y != c.y)
        gfx_half(g, b, c, a, c, c.y, color);
}

#ifdef __cplusplus
}
#endif

#endif
