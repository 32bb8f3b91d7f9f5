/* fragment/pattern.h: patterns and tiles as brushes (brush.h), and stipples in front of any paint.
 *
 * All are anchored to the frame: what a pixel gets depends on its place alone, so strips agree and
 * shapes that touch go on in each other.
 */
#ifndef ETCH_FRAGMENT_PATTERN_H
#define ETCH_FRAGMENT_PATTERN_H

#include "brush.h"

/* Eight rows of eight columns: pixel (x, y) is bit 7 - x mod 8 of row[y mod 8], so that a row of
 * 0xC0 is two columns on the left of each eight. */
struct etch_pattern {
    struct etch_brush brush;
    const uint8_t *row; /* the caller's, 8 */
    uint16_t color[2];  /* of clear and of set bits */
};
void etch_pattern_init(struct etch_pattern *p, const uint8_t *row, uint16_t clear, uint16_t set);

/* An image that repeats in both directions: (x, y) is a place of its upper left corner. */
struct etch_tile {
    struct etch_brush brush;
    const uint16_t *texels; /* the caller's, row 0 first; byte order as brush.h says */
    uint16_t width, height, stride;
    int16_t x, y;
};

/* ETCH_EINVAL if texels is NULL, a side is 0 or above 32767, or the stride is less than the width.
 */
enum etch_status etch_tile_init(struct etch_tile *t, const uint16_t *texels, uint16_t width,
                                uint16_t height, uint16_t stride, int16_t x, int16_t y);

/* Of the pixels of a shape, those whose bit of a pattern is set go on to another paint: a pattern
 * of which one colour is transparent, a hatch over a gradient, a dotted outline. */
struct etch_stipple_paint {
    struct etch_paint paint; /* .kernel = etch_kernel_stipple */
    const uint8_t *row;      /* the caller's, as for struct etch_pattern */
    const struct etch_paint *through;
};
etch_kernel etch_kernel_stipple;

/* The same for covers. */
struct etch_cover_stipple_paint {
    struct etch_cover_paint paint; /* .kernel = etch_cover_stipple */
    const uint8_t *row;
    const struct etch_cover_paint *through;
};
etch_cover_kernel etch_cover_stipple;

/* Of the pixels of a line, those whose bit is set: pixel k from (x0, y0) along the longer axis has
 * bit 15 - k mod 16. draw/line_stipple.h sets it up. */
struct etch_line_stipple_paint {
    struct etch_paint paint; /* .kernel = etch_kernel_line_stipple */
    const struct etch_paint *through;
    uint16_t pattern;
    bool steep; /* k counts rows */
    int32_t start;
    int8_t step; /* 1 or -1 */
};
etch_kernel etch_kernel_line_stipple;

#endif
