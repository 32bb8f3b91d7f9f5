/* ports/spi_lcd/dither.h: ordered dithering of luminance. The grey senders use it. */
#ifndef ETCH_PORTS_SPI_LCD_DITHER_H
#define ETCH_PORTS_SPI_LCD_DITHER_H

#include "lcd.h"

/* The threshold of frame pixel (x, y), 2 .. 254: Bayer's 8 x 8 matrix, whose cell is the bits of
 * x ^ y and y, interleaved from the last one on, times 4 and 2 more. The mean is 128. */
ETCH_INLINE uint8_t etch_lcd_threshold(int16_t x, int16_t y)
{
    const unsigned a = (unsigned)(x ^ y) & 7, b = (unsigned)y & 7;
    const unsigned cell = (a & 1) << 5 | (b & 1) << 4 | (a & 2) << 2 | (b & 2) << 1 | (a & 4) >> 1 |
                          (b & 4) >> 2;

    return (uint8_t)(cell * 4 + 2);
}

/* The grey level of a pixel, 0 .. most, most <= 15: the luminance L = 0 .. 255 scaled to most,
 * rounded up or down so that the mean over the matrix is exact to 1/64.
 * (L most + threshold) / 255 <= (3825 + 254) / 255 < 16; v / 255 = (v + 1 + (v >> 8)) >> 8 for
 * every v < 65535. */
ETCH_INLINE uint8_t etch_lcd_gray(uint16_t pixel, int16_t x, int16_t y, uint8_t most)
{
    const uint16_t color = etch_lcd_color(pixel);
    const uint16_t sum = (uint16_t)(77U * etch_rgb565_red(color) + 150U * etch_rgb565_green(color) +
                                    29U * etch_rgb565_blue(color)); /* <= 65280 */
    const uint16_t v = (uint16_t)((sum >> 8) * most + etch_lcd_threshold(x, y));

    return (uint8_t)((v + 1U + (v >> 8)) >> 8);
}

#endif
