/* fragment/barycentric.h: a user's function per pixel, given barycentric coordinates. */
#ifndef ETCH_FRAGMENT_BARYCENTRIC_H
#define ETCH_FRAGMENT_BARYCENTRIC_H

#include "../base/paint.h"

/* The colour of frame pixel (x, y), in the surface's byte order. b[i] is the weight of the
 * caller's vertex i in 16.16, 0 .. 65536; the three sum to 65536. */
typedef uint16_t etch_barycentric_function(void *context, int16_t x, int16_t y,
                                           const uint32_t b_q16[3]);

struct etch_barycentric_paint {
    struct etch_paint paint; /* .kernel = etch_kernel_barycentric */
    struct etch_plane b[2];  /* weights of the sorted vertices 0 and 1, 1.31 */
    uint8_t order[3];        /* from the triangle's set-up */
    etch_barycentric_function *color;
    void *context; /* the caller's, passed on */
};

/* Calls paint->color for every pixel and writes what it returns. Each of the first two sorted
 * weights errs by at most 1/2 + (x + y + 1) / 2^16 units of 16.16, the third is the rest. */
etch_kernel etch_kernel_barycentric;

#endif
