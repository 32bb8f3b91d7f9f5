/* fragment/gradient.h: linear and radial gradients as brushes (brush.h).
 *
 *      static const struct etch_stop sky[] = {
 *          {0, 20, 40, 120}, {40000, 90, 150, 230}, {65535, 250, 240, 220}};
 *      uint16_t color[64];
 *      struct etch_ramp ramp;
 *      struct etch_gradient_linear down;
 *
 *      etch_ramp_init(&ramp, color, 6, sky, 3);
 *      etch_gradient_linear_init(&down, &ramp, 0, 0, 0, 239);
 *
 * The colours between stops are worked out once, 2^bits of them, and a pixel takes one: the error
 * of its place is below 2^-bits of the gradient. RGB565 has 64 steps at most, so bits of 6 suffice
 * between two colours.
 */
#ifndef ETCH_FRAGMENT_GRADIENT_H
#define ETCH_FRAGMENT_GRADIENT_H

#include "brush.h"

/* A colour at a place, in 65536ths of the way. */
struct etch_stop {
    uint16_t at;
    uint8_t r, g, b;
};

struct etch_ramp {
    const uint16_t *color; /* the caller's, 2^bits */
    uint8_t bits;
};

/* Fills the caller's color[0 .. 2^bits - 1], which the ramp then refers to. Entry i is the gradient
 * at (i + 1/2) / 2^bits of the way: each channel, linear between the stops around, as that of
 * etch_rgb565 rounded to nearest once, ties upwards. Before the first stop is its colour, after the
 * last its; where stops have the same place the last one counts from there on. One division a
 * channel and entry. ETCH_EINVAL if bits is not 1 .. 8, count 0, or the places fall. */
enum etch_status etch_ramp_init(struct etch_ramp *ramp, uint16_t *color, uint8_t bits,
                                const struct etch_stop *stop, uint8_t count);

/* The same in the other byte order: for etch_kernel_brush on surfaces in rgb565_swapped. */
enum etch_status etch_ramp_init_swapped(struct etch_ramp *ramp, uint16_t *color, uint8_t bits,
                                        const struct etch_stop *stop, uint8_t count);

/* From the centre of pixel (x0, y0) to that of (x1, y1), and beyond both in the colours of the
 * ends. */
struct etch_gradient_linear {
    struct etch_brush brush;
    const struct etch_ramp *ramp;
    int16_t x0, y0;
    int32_t dx, dy;
    uint32_t square; /* dx^2 + dy^2 < 2^31 */
};

/* A pixel (x, y) takes entry floor(2^bits s / d), held to the ramp, with s = (x - x0) dx + (y - y0)
 * dy and d = dx^2 + dy^2: exactly. ETCH_EINVAL if the ends are one pixel or more than 46,340 apart.
 * A row takes a division of `bits` steps and one of 32 bits, a pixel two sums; where dx is 0 a row
 * is filled in one colour. */
enum etch_status etch_gradient_linear_init(struct etch_gradient_linear *g,
                                           const struct etch_ramp *ramp, int16_t x0, int16_t y0,
                                           int16_t x1, int16_t y1);

/* From the centre of pixel (cx, cy) to the distance r all round, and beyond in the colour of the
 * end. */
struct etch_gradient_radial {
    struct etch_brush brush;
    const struct etch_ramp *ramp;
    int16_t cx, cy, r;
};

/* A pixel at the distance e takes entry floor(2^bits e / r), held to the ramp: exactly, by
 * comparing squares. ETCH_EINVAL if r is below 1. A row takes a square root and a division of 32
 * bits, a pixel two 64-bit sums. */
enum etch_status etch_gradient_radial_init(struct etch_gradient_radial *g,
                                           const struct etch_ramp *ramp, int16_t cx, int16_t cy,
                                           int16_t r);

#endif
