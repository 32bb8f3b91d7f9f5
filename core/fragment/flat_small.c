/* fragment/flat_small.c: runs of one colour, in few bytes. See flat_small.h. */
#include "flat_small.h"

void etch_kernel_flat_small(const struct etch_surface *surface, int16_t y0,
                            const struct etch_run *runs, uint8_t n, const struct etch_paint *paint)
{
    const uint16_t color = ((const struct etch_flat_paint *)paint)->color;
    const uintptr_t stride = (uintptr_t)surface->stride * 2;
    uintptr_t row = etch_surface_row(surface, surface->pixels, y0);

    do {
        uint16_t *pixel = (uint16_t *)(row + (uintptr_t)(uint16_t)runs->x0 * 2);
        int32_t left = runs->x1 - runs->x0;

        for (; (left -= 2) >= 0; pixel += 2)
            pixel[0] = pixel[1] = color;
        if ((left & 1) != 0)
            *pixel = color;
        runs++;
        row += stride;
    } while (--n != 0);
}
