/* tests/product: the plot of chart.c: two series of samples that scroll, and the lines through
 * them.
 *
 * A thick line through all samples would take some 300 edges, 13 KB. Clips change no pixel, so
 * the line is drawn in slices of 24 columns, and within a strip only edges that cross its rows
 * are kept: 128 edges, 5.6 KB, are enough, for every height of strips. */
#ifndef TESTS_PRODUCT_PLOT_H
#define TESTS_PRODUCT_PLOT_H

#include "parts.h"

enum {
    LEFT = 38, /* half-open */
    RIGHT = 198,
    TOP = 98,
    BOTTOM = 184,

    STEP = 4, /* columns from sample to sample */
    SAMPLES = (RIGHT - LEFT) / STEP + 3
};

/* Samples in hundredths, the newest last; the values at BOTTOM and TOP. */
struct series {
    int16_t sample[SAMPLES];
    int16_t low, high;
    uint32_t rgb;
    int32_t width_q8;
};

extern struct series warm, wet;

/* What the sensors said up to this tick; the plot moves a column a tick. */
void plot_prepare(uint32_t tick);

/* The number of the sample after the newest. */
uint32_t plot_newest(void);

/* Where sample i is. */
struct etch_point_q8 plot_place(const struct series *series, int i);

/* Both lines, inside the plot, and the area below the first in a brush. */
void plot_lines(const struct etch_surface *s, const struct etch_brush *brush);

/* The point at which a line leaves the plot on the right. */
void plot_head(const struct etch_surface *s, const struct series *series);

#endif
