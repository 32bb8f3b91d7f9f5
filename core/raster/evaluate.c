/* raster/evaluate.c: incremental linear evaluation. Called by applications. See evaluate.h. */
#include "evaluate.h"

void etch_evaluate_rect(const struct etch_plane *plane, uint8_t count, struct etch_rect rect,
                        uint32_t *work, etch_evaluate_function *function, void *context)
{
    uint32_t *const value = work, *const first = work + count; /* of the pixel, of its row */

    if (etch_rect_is_empty(rect))
        return;
    for (uint8_t k = 0; k < count; k++)
        first[k] = etch_plane_at(&plane[k], rect.x0, rect.y0);
    for (int16_t y = rect.y0; y < rect.y1; y++) {
        for (uint8_t k = 0; k < count; k++) {
            value[k] = first[k];
            first[k] = etch_wrap_add(first[k], plane[k].dy);
        }
        for (int16_t x = rect.x0; x < rect.x1; x++) {
            function(context, x, y, value);
            for (uint8_t k = 0; k < count; k++)
                value[k] = etch_wrap_add(value[k], plane[k].dx);
        }
    }
}
