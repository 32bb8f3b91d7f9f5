/* fragment/texture_block.h: blocks of 16 columns, linear between their ends; no part of the API.
 *
 * Blocks begin at multiples of 16 of the frame, so that a pixel has the same coordinates whatever
 * run, clip or strip it is drawn in. A block without a pixel that passes costs no divide.
 */
#ifndef ETCH_FRAGMENT_TEXTURE_BLOCK_H
#define ETCH_FRAGMENT_TEXTURE_BLOCK_H

#include "texture_divide.h"

/* Paints the columns x .. x + n - 1 of row y; n > 0. */
void etch_texel_blocks(uint16_t *pixel, int32_t x, uint32_t n, int32_t y,
                       const struct etch_perspective_paint *p);

/* Depth first: it finds the pixels that pass, run by run. */
ETCH_INLINE void etch_perspective_rows(const struct etch_surface *surface, int16_t y0,
                                       const struct etch_run *runs, uint8_t n,
                                       const struct etch_perspective_paint *p,
                                       etch_depth_test *passes)
{
    const struct etch_run *const last = runs + n;
    const uintptr_t stride = (uintptr_t)surface->stride * 2;
    const uintptr_t to_pixel = etch_wrap_address_sub((uintptr_t)surface->pixels,
                                                     (uintptr_t)surface->depth);
    uintptr_t row = etch_surface_row(surface, passes != NULL ? surface->depth : surface->pixels,
                                     y0);

    for (int16_t y = y0; runs != last; runs++, y++, row = etch_wrap_address_add(row, stride)) {
        uint16_t *stored = (uint16_t *)etch_wrap_address_add(row, (uintptr_t)runs->x0 * 2);
        const uint16_t *const end = stored + (runs->x1 - runs->x0);
        uint32_t z = 0;

        if (stored == end)
            continue;
        if (passes == NULL) {
            etch_texel_blocks(stored, runs->x0, (uint32_t)(end - stored), y, p);
            continue;
        }
        z = etch_plane_at(&p->z, runs->x0, y);
        while ((stored = etch_depth_scan(stored, end, &z, p->z.dx, passes)) != end) {
            uint16_t *const first = stored;

            stored = etch_depth_write(stored, end, &z, p->z.dx, passes);
            etch_texel_blocks((uint16_t *)etch_wrap_address_add((uintptr_t)first, to_pixel),
                              (int32_t)(runs->x1 - (end - first)), (uint32_t)(stored - first), y,
                              p);
        }
    }
}

/* Defines the kernel `name`; `passes` NULL: no depth plane is read or written. */
#define ETCH_PERSPECTIVE_KERNEL(name, passes)                                                      \
    void name(const struct etch_surface *surface, int16_t y0, const struct etch_run *runs,         \
              uint8_t n, const struct etch_paint *paint)                                           \
    {                                                                                              \
        etch_perspective_rows(surface, y0, runs, n, (const struct etch_perspective_paint *)paint,  \
                              passes);                                                             \
    }

#endif
