/* fragment/stage.h: pixel work joined from stages at run time, for what no fused kernel does.
 *
 *      source -> texture -> fog -> alpha test -> stencil -> depth -> blend -> write
 *
 * The kernel etch_kernel_staged cuts runs into chunks of at most 16 pixels and hands each to a list
 * of stages, one after the other. A stage is a function over a chunk: it fills in values, takes
 * pixels out of it, or writes to the planes of the surface. A program links the stages that it
 * names and no others; one of your own is written the same way. A fused kernel (template.h) of the
 * same work gives the same pixels, about twice as fast.
 */
#ifndef ETCH_FRAGMENT_STAGE_H
#define ETCH_FRAGMENT_STAGE_H

#include "../base/paint.h"

/* Most pixels of a chunk. Chunks end where (x & 15) == 0, so that a block of columns is the
 * frame's, whatever the run, the clip or the strip. */
#define ETCH_CHUNK 16

/* Pixels x .. x + n - 1 of row y, all inside the surface's clip. A value is only defined for pixels
 * that are still alive, and once a stage has set it. */
struct etch_chunk {
    const struct etch_surface *surface;
    const struct etch_paint *paint; /* the primitive's: sources find their planes behind it */
    size_t first;                   /* index of pixel x in the surface's planes */
    int16_t x, y;
    uint16_t n;     /* 1 .. ETCH_CHUNK */
    uint16_t alive; /* bit i: pixel x + i is still to be drawn */

    /* Colour in output steps with fraction and without the half of rounding, so that it is rounded
     * once, when it is written: red and blue 5.11 (0 .. 31 << 11), green 6.10 (0 .. 63 << 10).
     * Alpha 8.8 (0 .. 255 << 8). */
    uint16_t r[ETCH_CHUNK], g[ETCH_CHUNK], b[ETCH_CHUNK], a[ETCH_CHUNK];
    uint16_t z[ETCH_CHUNK];               /* depth as it is stored */
    int32_t u[ETCH_CHUNK], v[ETCH_CHUNK]; /* texture coordinates, 16.16 texels */
};

typedef void etch_stage_function(struct etch_chunk *chunk, const void *data);

struct etch_stage {
    etch_stage_function *run; /* NULL ends a list */
    const void *data;         /* what the stage documents; the caller's */
};

/* The head of every paint of etch_kernel_staged; planes that sources read follow it. */
struct etch_staged_paint {
    struct etch_paint paint; /* .kernel = etch_kernel_staged */
    const struct etch_stage *stages;
};

etch_kernel etch_kernel_staged;

#endif
