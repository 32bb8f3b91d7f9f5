/* fragment/template.h: how kernels of your own are made. (Those shipped with depth write it first
 * and give colour to spans afterwards: depth_rows.h. The pixels are the same.)
 *
 * A kernel is a loop over runs with three parts put in as constants, so that the compiler
 * fuses them and drops what is not there:
 *
 *      a shader      start at a pixel, step to the next, give the colour
 *      a depth test  one of the eight below, or NULL
 *      depth write   whether a pixel that passes also replaces the stored depth
 *
 * One line makes a kernel:
 *
 *      ETCH_KERNEL(my_kernel, etch_gouraud_shader, etch_depth_greater, true)
 *
 * and a shader of your own is three small inline functions (see gouraud_shader.h).
 */
#ifndef ETCH_FRAGMENT_TEMPLATE_H
#define ETCH_FRAGMENT_TEMPLATE_H

#include "../base/paint.h"

/* What a shader carries from pixel to pixel of a run. A member that it does not use costs
 * nothing. */
struct etch_fragment {
    uint32_t v[4]; /* interpolated values, in the shader's formats */
    int16_t x, y;  /* frame pixel */
};

struct etch_shader {
    void (*start)(struct etch_fragment *f, const struct etch_paint *paint); /* at (f->x, f->y) */
    void (*step)(struct etch_fragment *f, const struct etch_paint *paint);  /* one pixel right */
    uint16_t (*color)(const struct etch_fragment *f, const struct etch_paint *paint);
};

/* True if a fragment at `depth` may replace a pixel at `stored`. */
typedef bool etch_depth_test(uint16_t depth, uint16_t stored);

ETCH_INLINE bool etch_depth_never(uint16_t depth, uint16_t stored)
{
    (void)depth, (void)stored;
    return false;
}
ETCH_INLINE bool etch_depth_less(uint16_t depth, uint16_t stored)
{
    return depth < stored;
}
ETCH_INLINE bool etch_depth_equal(uint16_t depth, uint16_t stored)
{
    return depth == stored;
}
ETCH_INLINE bool etch_depth_lequal(uint16_t depth, uint16_t stored)
{
    return depth <= stored;
}
ETCH_INLINE bool etch_depth_greater(uint16_t depth, uint16_t stored)
{
    return depth > stored;
}
ETCH_INLINE bool etch_depth_notequal(uint16_t depth, uint16_t stored)
{
    return depth != stored;
}
ETCH_INLINE bool etch_depth_gequal(uint16_t depth, uint16_t stored)
{
    return depth >= stored;
}
ETCH_INLINE bool etch_depth_always(uint16_t depth, uint16_t stored)
{
    (void)depth, (void)stored;
    return true;
}

/* Every paint of a kernel with a depth test begins like this. */
struct etch_depth_paint {
    struct etch_paint paint;
    struct etch_plane z; /* 16.16 + 1/2: the depth of a pixel is the upper half */
};

/* The pixels of one run without a depth plane, from the fragment's on. */
ETCH_INLINE void etch_shade_run(uint16_t *pixel, uint32_t n, struct etch_fragment *f,
                                const struct etch_paint *paint, const struct etch_shader shader)
{
    uint16_t *const end = pixel + n;

    while (pixel != end) {
        *pixel++ = shader.color(f, paint);
        shader.step(f, paint);
    }
}

/* The first pixel from `stored` on that passes, or end; *z follows. Eight at a time, because most
 * pixels of a deep scene fail here: 5.4 instructions each on ARMv6-M (W10), where four at a time
 * need 5.8 and more than eight gain little. */
ETCH_INLINE uint16_t *etch_depth_scan(uint16_t *stored, const uint16_t *end, uint32_t *z,
                                      uint32_t dz, etch_depth_test *passes)
{
    uint32_t depth = *z;

    for (; end - stored >= 8; stored += 8) {
        ETCH_UNROLL(8)
        for (uint8_t i = 0; i < 8; i++) {
            if (passes((uint16_t)(depth >> 16), stored[i])) {
                *z = depth;
                return stored + i;
            }
            depth = etch_wrap_add(depth, dz);
        }
    }
    for (; stored != end && !passes((uint16_t)(depth >> 16), *stored); stored++)
        depth = etch_wrap_add(depth, dz);
    *z = depth;
    return stored;
}

/* The same with one: scans to the first pixel that passes and shades while pixels pass, so that
 * what fails costs no colour. `to_pixel` leads from a depth's address to its pixel's. */
ETCH_INLINE void etch_shade_depth_run(uint16_t *stored, uintptr_t to_pixel, int16_t x0, int16_t x1,
                                      int16_t y, const struct etch_paint *paint,
                                      const struct etch_shader shader, etch_depth_test *passes,
                                      const bool writes)
{
    const struct etch_plane *const plane = &((const struct etch_depth_paint *)paint)->z;
    const uint32_t dz = plane->dx;
    const uint16_t *const end = stored + (x1 - x0);
    uint32_t z = etch_plane_at(plane, x0, y);
    struct etch_fragment f = {{0, 0, 0, 0}, x0, y};

    while ((stored = etch_depth_scan(stored, end, &z, dz, passes)) != end) {
        f.x = (int16_t)(x1 - (end - stored));
        shader.start(&f, paint);
        do {
            if (writes)
                *stored = (uint16_t)(z >> 16);
            *(uint16_t *)etch_wrap_address_add((uintptr_t)stored, to_pixel) = shader.color(&f,
                                                                                           paint);
            shader.step(&f, paint);
            z = etch_wrap_add(z, dz);
            stored++;
        } while (stored != end && passes((uint16_t)(z >> 16), *stored));
    }
}

/* A whole block of runs. `passes` NULL: no depth plane is read or written. */
ETCH_INLINE void etch_shade_runs(const struct etch_surface *s, int16_t y0,
                                 const struct etch_run *runs, uint8_t n,
                                 const struct etch_paint *paint, const struct etch_shader shader,
                                 etch_depth_test *passes, const bool writes)
{
    const struct etch_run *const end = runs + n;
    const uintptr_t stride = (uintptr_t)s->stride * 2;
    uintptr_t row = etch_surface_row(s, passes != NULL ? s->depth : s->pixels, y0);
    const uintptr_t to_pixel = etch_wrap_address_sub((uintptr_t)s->pixels, (uintptr_t)s->depth);

    ETCH_ASSERT(passes == NULL || s->depth != NULL);
    for (int16_t y = y0; runs != end; runs++, y++, row += stride) {
        const int16_t x0 = runs->x0, x1 = runs->x1;
        uint16_t *const first = (uint16_t *)etch_wrap_address_add(row, (uintptr_t)x0 * 2);

        if (x0 == x1)
            continue;
        if (passes != NULL) {
            etch_shade_depth_run(first, to_pixel, x0, x1, y, paint, shader, passes, writes);
        } else {
            struct etch_fragment f = {{0, 0, 0, 0}, x0, y};

            shader.start(&f, paint);
            etch_shade_run(first, (uint32_t)(x1 - x0), &f, paint, shader);
        }
    }
}

/* Defines the kernel `name`. */
#define ETCH_KERNEL(name, shader, passes, writes)                                                  \
    void name(const struct etch_surface *surface, int16_t y0, const struct etch_run *runs,         \
              uint8_t n, const struct etch_paint *paint)                                           \
    {                                                                                              \
        etch_shade_runs(surface, y0, runs, n, paint, shader, passes, writes);                      \
    }

#endif
