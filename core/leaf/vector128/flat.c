/* leaf/vector128/flat.c: etch_kernel_flat by vectors, in place of fragment/flat.c. */
#include "../../fragment/flat.h"
#include "fill_row.h"

void etch_kernel_flat(const struct etch_surface *surface, int16_t y0, const struct etch_run *runs,
                      uint8_t n, const struct etch_paint *paint)
{
    const uint32_t color = ((const struct etch_flat_paint *)paint)->color;
    const vector_u16 value = (vector_u16)vector_all(color * UINT32_C(0x10001));
    const struct etch_run *const end = runs + n;
    const uintptr_t stride = (uintptr_t)surface->stride * 2;
    uintptr_t row = etch_surface_row(surface, surface->pixels, y0);

    for (; runs != end; runs++, row = etch_wrap_address_add(row, stride)) {
        const uint32_t x0 = (uint16_t)runs->x0, x1 = (uint16_t)runs->x1;

        fill_row((uint16_t *)etch_wrap_address_add(row, (uintptr_t)x0 * 2), x1 - x0, value);
    }
}
