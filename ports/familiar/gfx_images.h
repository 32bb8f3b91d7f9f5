/* ports/familiar/gfx_images.h: bitmaps and images under familiar names. See gfx.h. */
#ifndef ETCH_PORTS_FAMILIAR_GFX_IMAGES_H
#define ETCH_PORTS_FAMILIAR_GFX_IMAGES_H

#include "gfx.h"

/* The part of the rectangle (x, y, w, h) that may be written. */
ETCH_INLINE struct etch_rect gfx_visible(const struct gfx *g, int16_t x, int16_t y, int16_t w,
                                         int16_t h)
{
    return gfx_part(g, etch_rect_from_size(x, y, w, h)).clip;
}

/* Rows of whole bytes, bits from the highest (`first` 7) or the lowest (0) on; clear bits are
 * `background`, or left as they are where `opaque` is false. */
ETCH_INLINE void gfx_bits(struct gfx *g, int16_t x, int16_t y, const uint8_t *bits, int16_t w,
                          int16_t h, unsigned first, uint16_t color, uint16_t background,
                          bool opaque)
{
    const struct etch_rect r = gfx_visible(g, x, y, w, h);
    const uint16_t ink = gfx_stored(g, color), paper = gfx_stored(g, background);
    const uint32_t stride = ((uint32_t)(w > 0 ? w : 0) + 7) / 8;

    for (int16_t j = r.y0; j < r.y1; j++) {
        uint16_t *to = g->surface.pixels + etch_surface_index(&g->surface, r.x0, j);
        const uint8_t *row = bits + stride * (uint32_t)(j - y);

        for (int16_t i = r.x0; i < r.x1; i++, to++) {
            const uint32_t k = (uint32_t)(i - x);

            if ((row[k / 8] >> ((k & 7) ^ first) & 1) != 0)
                *to = ink;
            else if (opaque)
                *to = paper;
        }
    }
}

/* Set bits in a colour; rows begin with a byte, the left pixel is its highest bit. */
ETCH_INLINE void gfx_drawBitmap(struct gfx *g, int16_t x, int16_t y, const uint8_t *bitmap,
                                int16_t w, int16_t h, uint16_t color)
{
    gfx_bits(g, x, y, bitmap, w, h, 7, color, 0, false);
}

/* The same with clear bits in another. */
ETCH_INLINE void gfx_drawBitmapOn(struct gfx *g, int16_t x, int16_t y, const uint8_t *bitmap,
                                  int16_t w, int16_t h, uint16_t color, uint16_t background)
{
    gfx_bits(g, x, y, bitmap, w, h, 7, color, background, true);
}

/* XBM: the left pixel is a byte's lowest bit. */
ETCH_INLINE void gfx_drawXBitmap(struct gfx *g, int16_t x, int16_t y, const uint8_t *bitmap,
                                 int16_t w, int16_t h, uint16_t color)
{
    gfx_bits(g, x, y, bitmap, w, h, 0, color, 0, false);
}

/* w h colours, row 0 first; `exchanged`: their bytes are. `key` < 65536: those are left out. */
ETCH_INLINE void gfx_colors(struct gfx *g, int16_t x, int16_t y, int16_t w, int16_t h,
                            const uint16_t *data, bool exchanged, int32_t key)
{
    const struct etch_rect r = gfx_visible(g, x, y, w, h);

    for (int16_t j = r.y0; j < r.y1; j++) {
        uint16_t *to = g->surface.pixels + etch_surface_index(&g->surface, r.x0, j);
        const uint16_t *from = data + (uint32_t)(j - y) * (uint32_t)w + (uint32_t)(r.x0 - x);

        for (int16_t i = r.x0; i < r.x1; i++, to++, from++)
            if (key != *from)
                *to = exchanged == g->swapped ? *from : etch_rgb565_swap(*from);
    }
}

/* Plain RGB565. */
ETCH_INLINE void gfx_drawRGBBitmap(struct gfx *g, int16_t x, int16_t y, const uint16_t *bitmap,
                                   int16_t w, int16_t h)
{
    gfx_colors(g, x, y, w, h, bitmap, false, -1);
}

/* Whether pushImage takes plain RGB565 numbers (true), as image converters write, or words that
 * have the high byte first in memory (false, at first). */
ETCH_INLINE void gfx_setSwapBytes(struct gfx *g, bool swap)
{
    g->swap_bytes = swap;
}

#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
#define GFX_HIGH_BYTE_LAST false
#else
#define GFX_HIGH_BYTE_LAST true
#endif

ETCH_INLINE void gfx_pushImage(struct gfx *g, int16_t x, int16_t y, int16_t w, int16_t h,
                               const uint16_t *data)
{
    gfx_colors(g, x, y, w, h, data, GFX_HIGH_BYTE_LAST && !g->swap_bytes, -1);
}

/* Pixels of the colour `transparent`, plain RGB565, are left out. */
ETCH_INLINE void gfx_pushImageKey(struct gfx *g, int16_t x, int16_t y, int16_t w, int16_t h,
                                  const uint16_t *data, uint16_t transparent)
{
    const bool exchanged = GFX_HIGH_BYTE_LAST && !g->swap_bytes;

    gfx_colors(g, x, y, w, h, data, exchanged,
               exchanged ? etch_rgb565_swap(transparent) : transparent);
}

#endif
