/* fragment/flat.c: runs of one colour, without depth. See flat.h. */
#include "flat.h"
#include "../base/fill.h"

void etch_kernel_flat(const struct etch_surface *surface, int16_t y0, const struct etch_run *runs,
                      uint8_t n, const struct etch_paint *paint)
{
    const uint32_t twice = ((const struct etch_flat_paint *)paint)->color * UINT32_C(0x10001);
    const struct etch_run *const end = runs + n;
    const uintptr_t stride = (uintptr_t)surface->stride * 2;
    uintptr_t row = etch_surface_row(surface, surface->pixels, y0);

    for (; runs != end; runs++, row += stride) {
        const uint16_t x0 = (uint16_t)runs->x0, x1 = (uint16_t)runs->x1;

        etch_fill_row((uint16_t *)etch_wrap_address_add(row, (uintptr_t)x0 * 2), (uint32_t)x1 - x0,
                      twice);
    }
}
