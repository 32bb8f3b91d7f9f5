/* fragment/blend_template.h: how fused kernels that read the pixel they draw on are made, shipped
 * ones and yours: as template.h, without depth. One line makes a kernel:
 *
 *      ETCH_BLEND_KERNEL(my_kernel, my_blender)
 */
#ifndef ETCH_FRAGMENT_BLEND_TEMPLATE_H
#define ETCH_FRAGMENT_BLEND_TEMPLATE_H

#include "template.h"

struct etch_blender {
    void (*start)(struct etch_fragment *f, const struct etch_paint *paint); /* at (f->x, f->y) */
    void (*step)(struct etch_fragment *f, const struct etch_paint *paint);  /* one pixel right */
    /* what becomes of a pixel that is `pixel`, both in the surface's byte order */
    uint16_t (*blend)(const struct etch_fragment *f, const struct etch_paint *paint,
                      uint16_t pixel);
};

ETCH_INLINE void etch_blend_runs(const struct etch_surface *s, int16_t y0,
                                 const struct etch_run *runs, uint8_t n,
                                 const struct etch_paint *paint, const struct etch_blender blender)
{
    const struct etch_run *const end = runs + n;
    const uintptr_t stride = (uintptr_t)s->stride * 2;
    uintptr_t row = etch_surface_row(s, s->pixels, y0);

    for (int16_t y = y0; runs != end; runs++, y++, row += stride) {
        uint16_t *pixel = (uint16_t *)etch_wrap_address_add(row, (uintptr_t)runs->x0 * 2);
        const uint16_t *const stop = pixel + (runs->x1 - runs->x0);
        struct etch_fragment f = {{0, 0, 0, 0}, runs->x0, y};

        if (pixel == stop)
            continue;
        blender.start(&f, paint);
        do {
            *pixel = blender.blend(&f, paint, *pixel);
            blender.step(&f, paint);
        } while (++pixel != stop);
    }
}

/* Defines the kernel `name`. */
#define ETCH_BLEND_KERNEL(name, blender)                                                           \
    void name(const struct etch_surface *surface, int16_t y0, const struct etch_run *runs,         \
              uint8_t n, const struct etch_paint *paint)                                           \
    {                                                                                              \
        etch_blend_runs(surface, y0, runs, n, paint, blender);                                     \
    }

#endif
