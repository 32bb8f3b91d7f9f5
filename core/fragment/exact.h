/* fragment/exact.h: colours and depths correctly rounded at every pixel of every triangle.
 *
 * The exact mode. A channel is floor(c full / 255 + 1/2), c the exact rational value of the 8-bit
 * channel at the pixel's centre, full = 31 or 63; a depth is floor(z + 1/2). Error: 1/2 of a step
 * and nothing beyond it, for every triangle in range, on every surface.
 *
 * Planes of 32 bits walk as in the precise mode (gouraud.h); their error is known, so only where
 * the value is nearer than that to a step of the output is it asked of the exact numerators
 * (base/exact.h). That is one pixel in 85 with three channels, one depth in 32 on triangles whose
 * width and height add up to less than 1024 px.
 */
#ifndef ETCH_FRAGMENT_EXACT_H
#define ETCH_FRAGMENT_EXACT_H

#include "../base/exact.h"
#include "../base/paint.h"
#include "depth_rows.h"
#include "flat.h"
#include "gouraud.h"

/* Exact depth: begins every paint of a kernel below whose name has less or lequal. */
struct etch_exact_depth {
    struct etch_exact_plane n; /* of depths in 16.16 + 1/2 */
    uint64_t area;             /* D */
};

/* One colour and exact depth. */
struct etch_flat_exact_paint {
    struct etch_flat_depth_paint flat;
    struct etch_exact_depth depth;
};

/* Colours, for the kernels with depth also depths. */
struct etch_gouraud_exact_paint {
    struct etch_gouraud_paint gouraud; /* .paint.kernel = one of those below */
    struct etch_exact_depth depth;     /* .area is read by all, .n by kernels with depth */
    struct etch_exact_plane r, g, b;   /* of 62 c + 255, green 126 c + 255 */
};

etch_kernel etch_kernel_flat_exact_less;   /* passes where new < stored */
etch_kernel etch_kernel_flat_exact_lequal; /* new <= stored */

etch_kernel etch_kernel_gouraud_exact;
etch_kernel etch_kernel_gouraud_exact_less;
etch_kernel etch_kernel_gouraud_exact_lequal;

/* The same for surfaces in rgb565_swapped. */
etch_kernel etch_kernel_gouraud_exact_swapped;
etch_kernel etch_kernel_gouraud_exact_less_swapped;
etch_kernel etch_kernel_gouraud_exact_lequal_swapped;

/* Parts of these kernels: exact colours of a span, and exact depths of runs, with `exact` that of
 * the paint. */
etch_span etch_gouraud_exact_span, etch_gouraud_exact_span_swapped;
typedef void etch_depth_exact_rows(const struct etch_surface *surface, int16_t y0,
                                   const struct etch_run *runs, uint8_t n,
                                   const struct etch_paint *paint,
                                   const struct etch_exact_depth *exact, etch_span *span);
etch_depth_exact_rows etch_depth_exact_rows_less, etch_depth_exact_rows_lequal;

#endif
