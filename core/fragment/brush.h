/* fragment/brush.h: colours that depend on where a pixel is: gradients (gradient.h), patterns and
 * tiles (pattern.h), or your own, for any shape.
 *
 *      struct etch_brush_paint paint = {{etch_kernel_brush}, &gradient.brush, 255};
 *      etch_ellipse_runs(surface, 120, 160, 90, 60, &paint.paint);
 *
 * A brush gives the colours of a part of a row. Which they are depends on the pixel's place in the
 * frame alone, so clips and strips change nothing, and shapes that touch go on in each other.
 *
 *  etch_kernel_brush            replaces pixels; colours in the surface's byte order
 *  etch_kernel_brush_blend      with an opacity; colours are etch_rgb565's
 *  etch_cover_brush             the same by the covers of smooth shapes (raster/smooth.h)
 *  etch_source_brush            in a pipeline of stages (stage.h): every blend and mask there is
 *
 * Those called .._swapped are for surfaces in rgb565_swapped.
 */
#ifndef ETCH_FRAGMENT_BRUSH_H
#define ETCH_FRAGMENT_BRUSH_H

#include "../base/cover.h"
#include "stage.h"

struct etch_brush;

/* Writes the colours of pixels x .. x + n - 1 of row y of the frame; n >= 1. */
typedef void etch_brush_colors(const struct etch_brush *brush, int16_t x, int16_t y, uint16_t n,
                               uint16_t *color);

/* The head of every brush; what its function reads follows. */
struct etch_brush {
    etch_brush_colors *colors;
};

/* A brush for runs; it stays the caller's. */
struct etch_brush_paint {
    struct etch_paint paint; /* .kernel = one of the three below */
    const struct etch_brush *brush;
    uint8_t opacity; /* not read by etch_kernel_brush */
};

/* The colours as they are; they are written straight to the surface. */
etch_kernel etch_kernel_brush;

/* A channel becomes (s a + d (255 - a)) / 255, rounded to nearest (there are no ties), a the
 * opacity: with 255 the brush's, with 0 as it was. */
etch_kernel etch_kernel_brush_blend;
etch_kernel etch_kernel_brush_blend_swapped;

/* A brush for covers. With w = cover opacity a channel becomes what fragment/cover.h says of one
 * colour. */
struct etch_cover_brush_paint {
    struct etch_cover_paint paint; /* .kernel = one of the two below */
    const struct etch_brush *brush;
    uint8_t opacity;
};
etch_cover_kernel etch_cover_brush;
etch_cover_kernel etch_cover_brush_swapped;

/* Sets r, g and b of a chunk, to whole steps, and a to 255; data: const struct etch_brush, whose
 * colours are etch_rgb565's. */
etch_stage_function etch_source_brush;

#endif
