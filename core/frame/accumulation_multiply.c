/* frame/accumulation_multiply.c: fades a sum of frames. Called by applications whose sums go on
 * from frame to frame. See accumulation.h. */
#include "accumulation_rows.h"

/* Below 65535^2 + 2^15 < 2^32. */
static uint16_t scale(uint16_t sum, uint16_t numerator, uint16_t denominator)
{
    return accumulation_held((etch_mul_u16(sum, numerator) + denominator / 2U) / denominator);
}

void etch_accumulation_multiply(const struct etch_accumulation *a, struct etch_rect area,
                                uint16_t numerator, uint16_t denominator)
{
    area = etch_rect_intersect(a->window, area);
    if (etch_rect_is_empty(area) || denominator == 0)
        return;
    for (int16_t y = area.y0; y < area.y1; y++) {
        uint16_t *sum = accumulation_at(a, area.x0, y);
        uint16_t *const end = sum + 3 * (size_t)(area.x1 - area.x0);

        for (; sum != end; sum++)
            *sum = scale(*sum, numerator, denominator);
    }
}
