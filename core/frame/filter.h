/* frame/filter.h: 3 x 3 filters, strip by strip.
 *
 *      kernel      name                  weights               what it does
 *      any         etch_filter_draw      caller's, or below    sum / divisor + bias
 *      average     etch_filter_average   nine equal ones       as etch_filter_weights_average, in
 *                                                              half the time
 *      Sobel       etch_filter_sobel     two differences       (|across| + |down|) / 4: edges
 *
 * Each channel is filtered by itself, in output steps (31 or 63 to the full), rounded once, half
 * up, and held to its range. Use: see carry.h, with rows = columns = 1; beyond the frame stands its
 * nearest pixel. The source is in rgb565. Memory: 2 rows of the frame, and the source strip.
 */
#ifndef ETCH_FRAME_FILTER_H
#define ETCH_FRAME_FILTER_H

#include "carry.h"

struct etch_filter_weights {
    int8_t weight[9]; /* row by row, from the upper left neighbour */
    uint8_t divisor;  /* 1 .. 255 */
    int16_t bias;     /* -255 .. 255, of 255: where the result of 0 is to lie */
};

extern const struct etch_filter_weights etch_filter_weights_average; /* 1 everywhere, / 9 */
extern const struct etch_filter_weights etch_filter_weights_blur;    /* 1 2 1, 2 4 2, 1 2 1, / 16 */
extern const struct etch_filter_weights
    etch_filter_weights_sharpen; /* 5 less the four neighbours */
extern const struct etch_filter_weights etch_filter_weights_laplace; /* 8 less all neighbours */
extern const struct etch_filter_weights
    etch_filter_weights_emboss; /* lower right less upper left, on grey */
extern const struct etch_filter_weights etch_filter_weights_identity; /* the source itself */

/* Every channel c of a pixel becomes floor((sum of weight * c) / divisor + B + 1/2), with
 * B = bias * 31 or 63 / 255 rounded half up, held to 0 .. 31 or 63. A divisor of 0 counts as 1.
 * 220 instructions a pixel. */
void etch_filter_draw(struct etch_carry *c, const struct etch_surface *source,
                      const struct etch_surface *strip, const struct etch_filter_weights *weights);

/* 100 instructions a pixel. */
void etch_filter_average(struct etch_carry *c, const struct etch_surface *source,
                         const struct etch_surface *strip);

/* Per channel min(most, (|X| + |Y| + 2) / 4) with X = right column - left column and Y = lower
 * row - upper row, each weighted 1 2 1 (I. Sobel and G. Feldman, 1968). 160 instructions a
 * pixel. */
void etch_filter_sobel(struct etch_carry *c, const struct etch_surface *source,
                       const struct etch_surface *strip);

/* The same to a strip in rgb565_swapped. */
void etch_filter_draw_swapped(struct etch_carry *c, const struct etch_surface *source,
                              const struct etch_surface *strip,
                              const struct etch_filter_weights *weights);
void etch_filter_average_swapped(struct etch_carry *c, const struct etch_surface *source,
                                 const struct etch_surface *strip);
void etch_filter_sobel_swapped(struct etch_carry *c, const struct etch_surface *source,
                               const struct etch_surface *strip);

#endif
