/* raster/edge_flags_runs.c: rows of bits to runs. Called by applications. See edge_flags.h. */
#include "edge_flags.h"
#include "run_band.h"

/* Eight pixels at a time where no bit is set. */
static void row(struct etch_run_band *band, int16_t y, const struct etch_edge_flags *f,
                const uint8_t *bits)
{
    int32_t x = f->rect.x0, from = 0;
    bool inside = false;

    for (uint16_t n = f->stride; n != 0; n--, bits++, x += 8) {
        uint8_t left = *bits;

        for (int32_t at = x; left != 0; at++, left = (uint8_t)((uint32_t)left << 1)) {
            if ((left & 0x80) == 0)
                continue;
            if (inside)
                etch_run_band_add(band, y, from, at);
            inside = !inside;
            from = at;
        }
    }
    if (inside)
        etch_run_band_add(band, y, from, f->rect.x1);
}

void etch_edge_flags_runs(const struct etch_surface *surface, const struct etch_edge_flags *f,
                          const struct etch_paint *paint)
{
    const struct etch_rect seen = etch_rect_intersect(f->rect, surface->clip);
    struct etch_run_band band;

    if (etch_rect_is_empty(seen))
        return;
    etch_run_band_init(&band, surface, paint);
    for (int16_t y = seen.y0; y < seen.y1; y++) {
        row(&band, y, f, f->bits + (size_t)((int32_t)y - f->rect.y0) * f->stride);
        etch_run_band_row(&band, y);
    }
    etch_run_band_flush(&band);
}
