/* fragment/template.h: how kernels are made, shipped ones and yours.
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

/* The pixels of one run without a depth plane. */
ETCH_INLINE void etch_shade_run(uint16_t *pixel, uint16_t n, struct etch_fragment *f,
                                const struct etch_paint *paint, const struct etch_shader shader)
{
    for (; n != 0; n--) {
        *pixel++ = shader.color(f, paint);
        shader.step(f, paint);
    }
}

/* The same with one: colour is asked for only where the test passes. */
ETCH_INLINE void etch_shade_depth_run(uint16_t *pixel, uint16_t *stored, uint16_t n, uint32_t z,
                                      uint32_t dz, struct etch_fragment *f,
                                      const struct etch_paint *paint,
                                      const struct etch_shader shader, etch_depth_test *passes,
                                      const bool writes)
{
    for (; n != 0; n--, pixel++, stored++) {
        const uint16_t depth = (uint16_t)(z >> 16);

        if (passes(depth, *stored)) {
            if (writes)
                *stored = depth;
            *pixel = shader.color(f, paint);
        }
        z = etch_wrap_add(z, dz);
        shader.step(f, paint);
    }
}

/* A whole block of runs. `passes` NULL: no depth plane is read or written. */
ETCH_INLINE void etch_shade_runs(const struct etch_surface *s, int16_t y0,
                                 const struct etch_run *runs, uint8_t n,
                                 const struct etch_paint *paint, const struct etch_shader shader,
                                 etch_depth_test *passes, const bool writes)
{
    for (uint8_t i = 0; i < n; i++) {
        const struct etch_run run = runs[i];
        const uint16_t count = (uint16_t)(run.x1 - run.x0);
        const size_t at = etch_surface_index(s, run.x0, (int16_t)(y0 + i));
        struct etch_fragment f = {{0, 0, 0, 0}, run.x0, (int16_t)(y0 + i)};

        if (count == 0)
            continue;
        shader.start(&f, paint);
        if (passes != NULL) {
            const struct etch_plane *plane = &((const struct etch_depth_paint *)paint)->z;

            etch_shade_depth_run(s->pixels + at, s->depth + at, count,
                                 etch_plane_at(plane, f.x, f.y), plane->dx, &f, paint, shader,
                                 passes, writes);
        } else {
            etch_shade_run(s->pixels + at, count, &f, paint, shader);
        }
    }
}

/* Defines the kernel `name`. */
#define ETCH_KERNEL(name, shader, passes, writes)                                               \
    void name(const struct etch_surface *surface, int16_t y0, const struct etch_run *runs,      \
              uint8_t n, const struct etch_paint *paint)                                        \
    {                                                                                           \
        etch_shade_runs(surface, y0, runs, n, paint, shader, passes, writes);                   \
    }

#endif
