/* fragment/stipple.c: runs through an 8 x 8 stipple. Shapes call it through a paint. See pattern.h.
 */
#include "stipple_pieces.h"

void etch_kernel_stipple(const struct etch_surface *surface, int16_t y0,
                         const struct etch_run *runs, uint8_t n, const struct etch_paint *paint)
{
    const struct etch_stipple_paint *const p = (const struct etch_stipple_paint *)paint;

    for (uint8_t i = 0; i < n; i++) {
        const int16_t y = (int16_t)(y0 + i);

        stipple_run(surface, y, runs[i], p->row[y & 7] * UINT32_C(0x101), runs[i].x0, 1,
                    p->through);
    }
}
