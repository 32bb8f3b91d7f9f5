/* fragment/stipple_cover.c: covers through an 8 x 8 stipple. Smooth shapes call it. See pattern.h.
 */
#include "stipple_pieces.h"

void etch_cover_stipple(const struct etch_surface *surface, int16_t x, int16_t y, uint16_t n,
                        const int16_t *cover, const struct etch_cover_paint *paint)
{
    const struct etch_cover_stipple_paint *const p = (const struct etch_cover_stipple_paint *)paint;
    const uint32_t pattern = p->row[y & 7] * UINT32_C(0x101);
    int32_t at = x;

    for (;;) {
        const int32_t to = stipple_next(pattern, &at, (int32_t)x + n, at, 1);

        if (at == to)
            return;
        p->through->kernel(surface, (int16_t)at, y, (uint16_t)(to - at), cover + (at - x),
                           p->through);
        at = to;
    }
}
