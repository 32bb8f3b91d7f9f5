/* raster/run_band.h: gathers the runs of shapes that may have several in a row; no part of the API.
 *
 * A kernel takes runs of consecutive rows. Where the rows of a shape have several runs, the first
 * ones of up to 32 rows make one block, the second ones the next, and so on:
 *
 *      row 0    aaaa    bb        kernel(y0, a a a)
 *      row 1   aaaa    bbbb       kernel(y0, b b b)
 *      row 2   aaa      bb
 *
 * so that a pixel is handed over once, and from top to bottom by bands.
 */
#ifndef ETCH_RASTER_RUN_BAND_H
#define ETCH_RASTER_RUN_BAND_H

#include "../base/paint.h"

/* Most runs that are kept of one row; a row with more ends the band. */
#define ETCH_RUN_LANES 16

struct etch_run_band {
    const struct etch_surface *surface;
    const struct etch_paint *paint;
    int16_t y;                           /* of the band's first row */
    uint8_t rows, lanes;                 /* of the band; lane i begins at run[i * most] */
    uint8_t most;                        /* ETCH_RUN_BLOCK / lanes */
    uint8_t count;                       /* of `row` */
    struct etch_run row[ETCH_RUN_LANES]; /* the row that is being gathered */
    struct etch_run run[ETCH_RUN_BLOCK];
};

void etch_run_band_init(struct etch_run_band *band, const struct etch_surface *surface,
                        const struct etch_paint *paint);

/* Pixels x0 .. x1 - 1 of row y, cut to the clip's columns; joined to a run that ends at x0. The
 * runs of a row come from left to right, y is inside the clip. */
void etch_run_band_add(struct etch_run_band *band, int16_t y, int32_t x0, int32_t x1);

/* Ends the row y, below all rows before; rows may be left out. */
void etch_run_band_row(struct etch_run_band *band, int16_t y);

/* Hands over what is left. */
void etch_run_band_flush(struct etch_run_band *band);

#endif
