/* frame/shared.h: four samples a pixel of which neighbours share two: six for two pixels where
 * multisample.h takes eight, two for each of a row instead of four.
 *
 *      |0    |     |0    |           Two samples lie about each upright edge between pixels, 1/4 px
 *      |  3  |     |  3  |           to its left and right, and belong to the pixels on both sides.
 *     -+--o--+--o--+--o--+-  ->      In every other column they are mirrored, so that the four of a
 *      |  1  |     |  1  |           pixel lie in four columns and four rows. A pixel looks 1/4 px
 *      |    2|     |    2|           beyond its sides: a little softer than multisample.h.
 *
 * A relative of FLIPQUAD (T. Akenine-Moeller and J. Stroem, Graphics for the Masses, 2003), which
 * shares upwards too and would need a row of the next strip; here strips are independent. Use is
 * that of multisample.h, and so are the rules of coverage, depth and range; the colour of a
 * fragment, which here is a pair of samples, is that halfway between them if both are covered, else
 * at the one that is.
 *
 * Cell x stands for the edge left of pixel x, so a row of W pixels has W + 1 cells of two samples.
 * Whatever draws on whole pixels would smear them over both sides of an edge: draw 2D shapes after
 * the resolve.
 */
#ifndef ETCH_FRAME_SHARED_H
#define ETCH_FRAME_SHARED_H

#include "multisample.h"

#define ETCH_SHARED_SAMPLES 2

/* Where the samples of a cell are, from the centre of the pixel to its right: [0] and [1] of even
 * cells, [2] and [3] of odd ones. The second of a pair is in sample[1]. */
extern const struct etch_offset_q8 etch_shared_offsets[4];

struct etch_shared_samples {
    struct etch_surface sample[ETCH_SHARED_SAMPLES]; /* window: a column wider than the strip's */
};

/* Makes the two surfaces; `pixels`, and `depth` unless it is NULL, hold
 * ETCH_SHARED_SAMPLES * (width + 1) * height elements for a `window` of pixels. Returns what
 * etch_surface_init does; the window must end left of column 32767. */
enum etch_status etch_shared_init(struct etch_shared_samples *m, uint16_t *pixels, uint16_t *depth,
                                  struct etch_rect window);

/* What may be written, in pixels: the cells on both sides of these. */
void etch_shared_clip(struct etch_shared_samples *m, struct etch_rect clip);

typedef void etch_shared_painter(const struct etch_shared_samples *m,
                                 const struct etch_vertex *const v[3]);

etch_shared_painter etch_shared_flat;
etch_shared_painter etch_shared_flat_less;
etch_shared_painter etch_shared_flat_lequal;
etch_shared_painter etch_shared_gouraud;
etch_shared_painter etch_shared_gouraud_less;
etch_shared_painter etch_shared_gouraud_lequal;

struct etch_shared_sink {
    struct etch_sink sink; /* give &m.sink to etch_assembly */
    const struct etch_shared_samples *samples;
    etch_shared_painter *painter;
};

void etch_shared_sink_init(struct etch_shared_sink *sink, const struct etch_shared_samples *samples,
                           etch_shared_painter *painter);

/* Each pixel becomes the exact average of the four samples about it, rounded once, half up. */
void etch_shared_resolve(const struct etch_shared_samples *m, const struct etch_surface *out);
void etch_shared_resolve_swapped(const struct etch_shared_samples *m,
                                 const struct etch_surface *out);

#endif
