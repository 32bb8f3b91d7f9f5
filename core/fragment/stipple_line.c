/* fragment/stipple_line.c: the runs of a line through 16 bits. draw/line_stipple.c hands it to
 * lines. See pattern.h. */
#include "stipple_pieces.h"

void etch_kernel_line_stipple(const struct etch_surface *surface, int16_t y0,
                              const struct etch_run *runs, uint8_t n,
                              const struct etch_paint *paint)
{
    const struct etch_line_stipple_paint *const p = (const struct etch_line_stipple_paint *)paint;

    for (uint8_t i = 0; i < n; i++) {
        const int16_t y = (int16_t)(y0 + i);
        const int32_t k = ((p->steep ? y : runs[i].x0) - p->start) * p->step;

        stipple_run(surface, y, runs[i], p->pattern, k, p->steep ? 0 : p->step, p->through);
    }
}
