/* base/paint.h: what the raster stage hands to the fragment stage.
 *
 * A raster function turns a primitive into runs of pixels; a paint says what to do with them.
 * It knows nothing about colour, and the paint nothing about shapes.
 *
 *      raster:  y0, {x0,x1} {x0,x1} ..  ->  paint->kernel(surface, y0, runs, n, paint)
 */
#ifndef ETCH_BASE_PAINT_H
#define ETCH_BASE_PAINT_H

#include "surface.h"

/* Pixels x0 <= x < x1 of one row. x0 == x1 is a row without a pixel (a sliver between two
 * pixel centres); x1 < x0 does not occur. */
struct etch_run {
    int16_t x0, x1;
};

/* Most runs that one kernel call gets: 128 bytes of stack in the raster function. */
#define ETCH_RUN_BLOCK 32

struct etch_paint;

/* A fragment kernel: does the pixel work for runs[0 .. n-1], which lie on rows y0, y0 + 1, ..
 * y0 + n - 1 of the frame; 1 <= n <= ETCH_RUN_BLOCK. Every pixel is inside surface->clip, and
 * a primitive hands each pixel over at most once, top to bottom; shapes with several runs in a
 * row (polygons, implicit shapes) do so by bands of up to 32 rows, within a band one run of each
 * row after the other. `paint` is the one given to the raster function; a kernel finds its data
 * behind it. Users write their own in the same way: see fragment/template.h. */
typedef void etch_kernel(const struct etch_surface *surface, int16_t y0,
                         const struct etch_run *runs, uint8_t n, const struct etch_paint *paint);

/* The head of every paint: the first member of a struct with the kernel's data. */
struct etch_paint {
    etch_kernel *kernel;
};

/* The linear function of a varying over the frame, for the pixel centre of (x, y):
 *      value(x, y) = origin + x * dx + y * dy   modulo 2^32.
 * The format is the varying's own. Inside its triangle the true value lies in 0 .. 2^32 - 1,
 * so the modular one is right wherever a kernel asks, and does not depend on where a run, a
 * strip or a clip begins. */
struct etch_plane {
    uint32_t origin, dx, dy;
};

ETCH_INLINE uint32_t etch_plane_at(const struct etch_plane *p, int16_t x, int16_t y)
{
    return etch_wrap_add(p->origin, etch_wrap_add(etch_wrap_mul(p->dx, (uint32_t)(int32_t)x),
                                                  etch_wrap_mul(p->dy, (uint32_t)(int32_t)y)));
}

#endif
