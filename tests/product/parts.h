/* tests/product: what the three screens draw with: smooth shapes and text for panels that take the
 * high byte first, in pixels and sixteenths rather than 1/256. */
#ifndef TESTS_PRODUCT_PARTS_H
#define TESTS_PRODUCT_PARTS_H

#include "core/base/rgb565.h"
#include "core/draw/text.h"
#include "core/fragment/brush.h"
#include "core/raster/smooth_shapes.h"

/* Where the bytes of a pixel lie the other way round, plain kernels write them high byte first. */
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
#define PANEL_GLYPH etch_glyph_blend4
#define PANEL_COVER_FLAT etch_cover_flat
#define PANEL_COVER_BRUSH etch_cover_brush
#define PANEL_FLAT_BLEND etch_kernel_flat_blend
#define PANEL_STAGE_WRITE etch_stage_write
#define PANEL_SWAP(color) (color)
#else
#define PANEL_GLYPH etch_glyph_blend4_swapped
#define PANEL_COVER_FLAT etch_cover_flat_swapped
#define PANEL_COVER_BRUSH etch_cover_brush_swapped
#define PANEL_FLAT_BLEND etch_kernel_flat_blend_swapped
#define PANEL_STAGE_WRITE etch_stage_write_swapped
#define PANEL_SWAP(color) etch_rgb565_swap(color)
#endif

/* 0xRRGGBB, and how much of it: 255 is opaque. */
struct ink {
    uint32_t rgb;
    uint8_t opacity;
};

ETCH_INLINE struct ink solid(uint32_t rgb)
{
    const struct ink ink = {rgb, 255};

    return ink;
}

ETCH_INLINE struct ink glass(uint32_t rgb, uint8_t opacity)
{
    const struct ink ink = {rgb, opacity};

    return ink;
}

uint16_t color_of(uint32_t rgb); /* etch_rgb565 */

/* Covers of one row, for raster/smooth.h. */
extern int16_t cover_row[];

/* The place `radius_q4` sixteenths of a pixel from the middle of pixel (cx, cy), in the
 * direction `angle`. */
struct etch_point_q8 polar(int16_t cx, int16_t cy, int32_t radius_q4, uint16_t angle);

/* A corner or an edge in whole pixels: 0 is the left edge of pixel 0. */
ETCH_INLINE struct etch_point_q8 corner(int16_t x, int16_t y)
{
    const struct etch_point_q8 p = {x * INT32_C(256), y * INT32_C(256)};

    return p;
}

void fill_all(const struct etch_surface *s, uint32_t rgb);
void disc(const struct etch_surface *s, struct etch_point_q8 centre, int32_t radius_q4,
          struct ink ink);
void ring(const struct etch_surface *s, struct etch_point_q8 centre, int32_t outer_q4,
          int32_t inner_q4, struct ink ink);
void arc(const struct etch_surface *s, struct etch_point_q8 centre, int32_t outer_q4,
         int32_t inner_q4, uint16_t from, uint32_t sweep, struct ink ink);
void line(const struct etch_surface *s, struct etch_point_q8 a, struct etch_point_q8 b,
          int32_t width_q4, struct ink ink); /* round ends */
void box(const struct etch_surface *s, struct etch_rect r, int16_t radius, struct ink ink);
void border(const struct etch_surface *s, struct etch_rect r, int16_t radius, int32_t width_q4,
            struct ink ink);

/* Up to eight corners. */
void shape(const struct etch_surface *s, const struct etch_point_q8 *v, uint16_t n, struct ink ink);

/* A line of text about x, its baseline at y. */
void text(const struct etch_surface *s, const struct etch_font *font, uint32_t rgb, int16_t x,
          int16_t y, enum etch_align align, const char *string);

/* Decimal digits of value / 10^decimals, blanks between thousands, `unit` behind;
 * NUL-terminated, at most 23 characters. Returns `to`. */
char *number(char to[24], int32_t value, uint8_t decimals, const char *unit);

#endif
