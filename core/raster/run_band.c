/* raster/run_band.c: rows of several runs to blocks. Called by polygons and implicit shapes. See
 * run_band.h. */
#include "run_band.h"

void etch_run_band_init(struct etch_run_band *band, const struct etch_surface *surface,
                        const struct etch_paint *paint)
{
    band->surface = surface;
    band->paint = paint;
    band->rows = band->lanes = band->most = band->count = 0;
}

void etch_run_band_flush(struct etch_run_band *band)
{
    const struct etch_run *run = band->run;

    if (band->rows != 0)
        for (uint8_t i = 0; i < band->lanes; i++, run += band->most)
            band->paint->kernel(band->surface, band->y, run, band->rows, band->paint);
    band->rows = 0;
}

void etch_run_band_add(struct etch_run_band *band, int16_t y, int32_t x0, int32_t x1)
{
    const struct etch_rect *const clip = &band->surface->clip;

    if (x0 < clip->x0)
        x0 = clip->x0;
    if (x1 > clip->x1)
        x1 = clip->x1;
    if (x0 >= x1)
        return;
    if (band->count != 0 && band->row[band->count - 1].x1 == x0) {
        band->row[band->count - 1].x1 = (int16_t)x1;
        return;
    }
    if (band->count == ETCH_RUN_LANES) { /* too many to keep: each alone */
        etch_run_band_flush(band);
        for (uint8_t i = 0; i < ETCH_RUN_LANES; i++)
            band->paint->kernel(band->surface, y, &band->row[i], 1, band->paint);
        band->count = 0;
    }
    band->row[band->count].x0 = (int16_t)x0;
    band->row[band->count++].x1 = (int16_t)x1;
}

/* ETCH_RUN_BLOCK / count, once a band: a division would cost more flash than this file. */
static uint8_t rows_of(uint8_t count)
{
    uint8_t rows = 0;

    for (uint8_t left = ETCH_RUN_BLOCK; left >= count; left = (uint8_t)(left - count))
        rows++;
    return rows;
}

/* A band takes a row that needs no more lanes than it has, and at least half of them. */
void etch_run_band_row(struct etch_run_band *band, int16_t y)
{
    const uint8_t count = band->count;
    struct etch_run *run;

    if (band->rows == band->most || count > band->lanes || 2 * count < band->lanes ||
        y != band->y + band->rows)
        etch_run_band_flush(band);
    if (count == 0)
        return;
    if (band->rows == 0) {
        band->y = y;
        band->lanes = count;
        band->most = rows_of(count);
    }
    run = band->run + band->rows++;
    for (uint8_t i = 0; i < band->lanes; i++, run += band->most) {
        if (i < count)
            *run = band->row[i];
        else
            run->x0 = run->x1 = band->surface->clip.x0;
    }
    band->count = 0;
}
