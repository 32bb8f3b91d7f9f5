/* ports/familiar/gfx.h: etch under the names of Adafruit GFX and TFT_eSPI, in C:
 * `tft.drawLine(..)` becomes `gfx_drawLine(&tft, ..)`. Sketches in C++ include gfx.hpp instead
 * and stay as they are. README.md lists every name, its convention, and where ours differs.
 *
 *      gfx.h          state, rotation, pixels, lines, rectangles, colours
 *      gfx_shapes.h   circles, rounded rectangles, triangles, ellipses
 *      gfx_images.h   bitmaps, pushImage
 *      gfx_text.h     cursor, print, datum
 *      gfx_smooth.h   drawSmoothCircle, drawWideLine, drawArc ..
 *
 * All of it is in the headers, as static functions: what is not named takes nothing. No heap, no
 * statics. Colours are plain RGB565 numbers, whatever the surface has in memory. Coordinates are
 * those of the frame and every int16_t is legal; widths and heights below 1 draw nothing.
 *
 * What is drawn on: a surface of the frame loop (hal/frame.h). Where it holds the whole frame,
 * calls draw at once and the frame ends when the program says so; on strips the same calls are
 * made for each strip, from the same state:
 *
 *      gfx_begin(&tft, 240, 320, true);
 *      for (s = etch_frame_begin(&frame); s != NULL; s = etch_frame_next(&frame)) {
 *          tft.surface = *s;
 *          draw_screen(&tft);
 *      } */
#ifndef ETCH_PORTS_FAMILIAR_GFX_H
#define ETCH_PORTS_FAMILIAR_GFX_H

#ifdef __cplusplus
extern "C" {
#define _Static_assert static_assert
#define GFX_NOTHING                                                                                \
    {                                                                                              \
    }
#else
#define GFX_NOTHING                                                                                \
    {                                                                                              \
        0                                                                                          \
    }
#endif

#include "../../core/base/rgb565.h"
#include "../../core/base/surface.h"
#include "../../core/draw/shapes.h"
#include "../../core/raster/line.h"
#include "../../core/raster/rect.h"

struct gfx {
    struct etch_surface surface;          /* drawn on; without pixels (zeroed) nothing is */
    int16_t panel_width, panel_height;    /* at rotation 0 */
    uint8_t rotation;                     /* quarters */
    bool swapped;                         /* the surface has its bytes exchanged */
    bool swap_bytes;                      /* pushImage: its numbers are plain RGB565 */
    bool wrap;                            /* print: lines end at the right edge */
    int16_t cursor_x, cursor_y;           /* upper left pixel of the next character */
    uint16_t text_color, text_background; /* equal: nothing behind the letters */
    uint8_t size_x, size_y;               /* pixels of the frame to one of the font */
    uint8_t datum;                        /* enum gfx_datum: drawString */

    /* NULL, or called by gfx_setRotation: turns the display to g->rotation and sets g->surface
     * anew. */
    void (*turn)(struct gfx *g);
    void *context; /* turn's */
};

/* Nothing to draw on yet; rotation 0, white text of size 1 that wraps. `swapped`: surfaces have
 * ETCH_FORMAT_RGB565_SWAPPED. */
ETCH_INLINE void gfx_begin(struct gfx *g, int16_t width, int16_t height, bool swapped)
{
    const struct gfx none = GFX_NOTHING;

    *g = none;
    g->panel_width = width;
    g->panel_height = height;
    g->swapped = swapped;
    g->wrap = true;
    g->text_color = g->text_background = 0xFFFF;
    g->size_x = g->size_y = 1;
}

/* 8-bit channels, of which the low bits are dropped: 255 is full, but 128 is not what etch_rgb565
 * rounds it to. */
ETCH_INLINE uint16_t gfx_color565(uint8_t r, uint8_t g, uint8_t b)
{
    return (uint16_t)((r & 0xF8U) << 8 | (g & 0xFCU) << 3 | b >> 3);
}

/* ---- the frame ----------------------------------------------------------------------------- */

ETCH_INLINE int16_t gfx_width(const struct gfx *g)
{
    return (g->rotation & 1) != 0 ? g->panel_height : g->panel_width;
}

ETCH_INLINE int16_t gfx_height(const struct gfx *g)
{
    return (g->rotation & 1) != 0 ? g->panel_width : g->panel_height;
}

ETCH_INLINE uint8_t gfx_getRotation(const struct gfx *g)
{
    return g->rotation;
}

/* Turns the frame clockwise by quarters, modulo 4. */
ETCH_INLINE void gfx_setRotation(struct gfx *g, uint8_t quarters)
{
    g->rotation = quarters & 3;
    if (g->turn != NULL)
        g->turn(g);
}

/* A colour as the surface has it. */
ETCH_INLINE uint16_t gfx_stored(const struct gfx *g, uint16_t color)
{
    return g->swapped ? etch_rgb565_swap(color) : color;
}

/* ---- pixels, lines, rectangles --------------------------------------------------------------- */

ETCH_INLINE void gfx_drawPixel(struct gfx *g, int16_t x, int16_t y, uint16_t color)
{
    etch_point_draw(&g->surface, x, y, gfx_stored(g, color));
}

/* The pixel (x, y); 0 where the surface does not hold it. */
ETCH_INLINE uint16_t gfx_readPixel(const struct gfx *g, int16_t x, int16_t y)
{
    const struct etch_rect w = g->surface.window;

    if (x < w.x0 || x >= w.x1 || y < w.y0 || y >= w.y1)
        return 0;
    return gfx_stored(g, g->surface.pixels[etch_surface_index(&g->surface, x, y)]);
}

/* Both ends are drawn. */
ETCH_INLINE void gfx_drawLine(struct gfx *g, int16_t x0, int16_t y0, int16_t x1, int16_t y1,
                              uint16_t color)
{
    etch_line_draw(&g->surface, x0, y0, x1, y1, gfx_stored(g, color));
}

ETCH_INLINE void gfx_drawFastHLine(struct gfx *g, int16_t x, int16_t y, int16_t w, uint16_t color)
{
    etch_hline_draw(&g->surface, x, y, w, gfx_stored(g, color));
}

ETCH_INLINE void gfx_drawFastVLine(struct gfx *g, int16_t x, int16_t y, int16_t h, uint16_t color)
{
    etch_vline_draw(&g->surface, x, y, h, gfx_stored(g, color));
}

ETCH_INLINE void gfx_fillRect(struct gfx *g, int16_t x, int16_t y, int16_t w, int16_t h,
                              uint16_t color)
{
    etch_rect_fill(&g->surface, x, y, w, h, gfx_stored(g, color));
}

ETCH_INLINE void gfx_drawRect(struct gfx *g, int16_t x, int16_t y, int16_t w, int16_t h,
                              uint16_t color)
{
    etch_rect_draw(&g->surface, x, y, w, h, gfx_stored(g, color));
}

ETCH_INLINE void gfx_fillScreen(struct gfx *g, uint16_t color)
{
    etch_surface_clear(&g->surface, gfx_stored(g, color));
}

/* ---- for the other headers ------------------------------------------------------------------- */

/* Half-open, held to what an int16_t can say. */
ETCH_INLINE struct etch_rect gfx_area(int32_t x0, int32_t y0, int32_t x1, int32_t y1)
{
    struct etch_rect r;

    r.x0 = (int16_t)(x0 < INT16_MIN ? INT16_MIN : x0 > INT16_MAX ? INT16_MAX : x0);
    r.y0 = (int16_t)(y0 < INT16_MIN ? INT16_MIN : y0 > INT16_MAX ? INT16_MAX : y0);
    r.x1 = (int16_t)(x1 < INT16_MIN ? INT16_MIN : x1 > INT16_MAX ? INT16_MAX : x1);
    r.y1 = (int16_t)(y1 < INT16_MIN ? INT16_MIN : y1 > INT16_MAX ? INT16_MAX : y1);
    return r;
}

/* The surface with its clip narrowed to `area`. */
ETCH_INLINE struct etch_surface gfx_part(const struct gfx *g, struct etch_rect area)
{
    struct etch_surface part = g->surface;

    part.clip = etch_rect_intersect(part.clip, area);
    if (etch_rect_is_empty(part.clip))
        part.clip.x1 = part.clip.x0, part.clip.y1 = part.clip.y0;
    return part;
}

/* The pixels of an area. */
ETCH_INLINE void gfx_fill(const struct gfx *g, struct etch_rect area, uint16_t color)
{
    const struct etch_surface part = gfx_part(g, area);

    if (!etch_rect_is_empty(part.clip))
        etch_surface_clear(&part, gfx_stored(g, color));
}

#ifdef __cplusplus
}
#endif

#endif
