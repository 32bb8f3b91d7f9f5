/* tests/oracle: what Adafruit GFX and TFT_eSPI say their shapes are, one pixel at a time on the
 * window of a frame. Written from their documented conventions: ends and edges are drawn, a
 * circle of radius r is 2 r + 1 pixels wide, a triangle's rows go from edge to edge, rounded
 * towards the upper end. */
#ifndef TESTS_ORACLE_GFX_H
#define TESTS_ORACLE_GFX_H

#include "core/base/rect.h"

/* Forgets all: a window of at most 64 x 48 in one colour, of which `clip` may be written. */
void oracle_gfx_open(struct etch_rect window, struct etch_rect clip, uint16_t background);

/* A pixel of the window. */
uint16_t oracle_gfx_at(int32_t x, int32_t y);

void oracle_gfx_pixel(int32_t x, int32_t y, uint16_t color);
void oracle_gfx_line(int32_t x0, int32_t y0, int32_t x1, int32_t y1, uint16_t color);
void oracle_gfx_fill_rect(int32_t x, int32_t y, int32_t w, int32_t h, uint16_t color);
void oracle_gfx_circle(int32_t x, int32_t y, int32_t r, uint16_t color);
void oracle_gfx_disc(int32_t x, int32_t y, int32_t r, uint16_t color);
void oracle_gfx_round_rect(int32_t x, int32_t y, int32_t w, int32_t h, int32_t r, uint16_t color);
void oracle_gfx_fill_round_rect(int32_t x, int32_t y, int32_t w, int32_t h, int32_t r,
                                uint16_t color);
void oracle_gfx_fill_triangle(int32_t x0, int32_t y0, int32_t x1, int32_t y1, int32_t x2,
                              int32_t y2, uint16_t color);

#endif
