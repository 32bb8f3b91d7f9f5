/* fragment/stage.h: pixel work joined from stages at run time, for what no fused kernel does.
 *
 *      sources -> texture -> fog -> alpha test -> stencil -> depth -> read, blend, logic, write
 *      source.h   sampler.h  fog.h  test.h        stencil.h  test.h   blend.h          write.h
 *
 * The kernel etch_kernel_staged cuts runs into chunks of at most 16 pixels and hands each to a list
 * of stages, one after the other. A stage is a function over a chunk: it fills in values, takes
 * pixels out of it, or writes to the planes of the surface. A program links the stages that it
 * names and no others; one of your own is written the same way. A fused kernel (template.h) of the
 * same work gives the same pixels, about twice as fast. The painter that sets up what sources read
 * is etch_triangle_staged (draw/staged.h).
 *
 * Tests may stand before the sources of colour, if they do not ask for alpha: then hidden pixels
 * cost no colour, and the result is the same.
 */
#ifndef ETCH_FRAGMENT_STAGE_H
#define ETCH_FRAGMENT_STAGE_H

#include "../base/paint.h"

/* Most pixels of a chunk. Chunks end where (x & 15) == 0, so that a block of columns is the
 * frame's, whatever the run, the clip or the strip. */
#define ETCH_CHUNK 16

/* Pixels x .. x + n - 1 of row y, all inside the surface's clip. A source sets its value for all n
 * pixels, so that what computes with values need not look at `alive`; what writes to a plane must.
 * A value is undefined until a stage has set it. */
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

    uint16_t pixel[ETCH_CHUNK]; /* what is in the colour plane, as etch_rgb565 (write.h reads it) */
    uint16_t stencilled;        /* bit i: pixel x + i has passed the stencil test and waits for
                                   its operation, alive or not (stencil.h) */
};

#define ETCH_CHUNK_RED_MAX (UINT32_C(31) << 11) /* and blue */
#define ETCH_CHUNK_GREEN_MAX (UINT32_C(63) << 10)
#define ETCH_CHUNK_ALPHA_MAX (UINT32_C(255) << 8)

/* A channel of a chunk from its plane, 5.27 or 6.26 with the half of rounding in it, which goes off
 * again. What 16 bits cannot hold is cut: adding the half to what is left and cutting gives the
 * pixel that the plane itself gives. */
ETCH_INLINE uint32_t etch_chunk_channel(uint32_t plane, uint32_t half, uint32_t most)
{
    const uint32_t v = plane > half ? (plane - half) >> 16 : 0;

    return v < most ? v : most;
}

/* Alpha from its plane, 8.23 + 1/128, rounded to nearest. The plane is 2^16 .. 255 2^23 + 2^16 and
 * errs by less than 2^15, so it does not fall below 0. */
ETCH_INLINE uint32_t etch_chunk_alpha(uint32_t plane)
{
    const uint32_t less = (UINT32_C(1) << 16) - (UINT32_C(1) << 14);
    const uint32_t a = plane > less ? (plane - less) >> 15 : 0;

    return a < ETCH_CHUNK_ALPHA_MAX ? a : ETCH_CHUNK_ALPHA_MAX;
}

typedef void etch_stage_function(struct etch_chunk *chunk, const void *data);

struct etch_stage {
    etch_stage_function *run; /* NULL ends a list */
    const void *data;         /* what the stage documents, NULL if nothing; the caller's */
};

/* The head of every paint of etch_kernel_staged; planes that sources read follow it. */
struct etch_staged_paint {
    struct etch_paint paint; /* .kernel = etch_kernel_staged */
    const struct etch_stage *stages;
};

/* Runs the stages over every chunk of the runs. The rest of the list is left out for a chunk
 * without a pixel that is alive or stencilled. 400 bytes of stack. */
etch_kernel etch_kernel_staged;

#endif
