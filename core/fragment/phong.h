/* fragment/phong.h: Phong shading: normals interpolated, brought to length one, and lit at every
 * pixel, as a stage (stage.h). Source: B. T. Phong, "Illumination for computer generated pictures",
 * 1975.
 *
 *      static etch_varying *const varyings[] = {etch_varying_color, etch_varying_shade, NULL};
 *      const struct etch_phong phong = {etch_shade_phong, &lamps};
 *      const struct etch_stage stages[] = {
 *          {etch_source_color, NULL}, {etch_stage_phong, &phong}, {etch_stage_write, NULL},
 *          {NULL, NULL}};
 *      const struct etch_pipeline pipeline = {varyings, stages, etch_kernel_staged};
 *      struct etch_phong_planes planes;
 *
 *      etch_triangle_staged(surface, v, &pipeline, &planes.staged);
 *
 * The vertices are struct etch_shade_vertex (draw/mesh_shaded.h).
 */
#ifndef ETCH_FRAGMENT_PHONG_H
#define ETCH_FRAGMENT_PHONG_H

#include "../base/shade.h"
#include "source.h"

/* A value of the sorted vertex 0, and the differences of the others to it in eighths. */
struct etch_phong_value {
    int32_t base, one_q3, two_q3;
};

/* What the stage reads, set up by etch_varying_shade (draw/mesh_phong.h). */
struct etch_phong_planes {
    struct etch_staged_planes staged; /* first */
    struct etch_weights weights;
    struct etch_phong_value normal[3];   /* 8.24 */
    struct etch_phong_value position[3]; /* 16.16 / 2^position_down */
    uint8_t position_down;               /* 0 .. 5 */
};

/* The data of the stage. */
struct etch_phong {
    etch_shade_function *shade;
    const void *lighting; /* the shade function's */
};

/* Shades the chunk's r, g, b, which it takes and gives back rounded to 8 bits. In perspective: the
 * normal that is shaded is within 3 units of 2^-14 a component of the unit vector along the exact
 * interpolated one, where that is longer than 1/64 (zero has no direction and stays zero); the
 * position is within 2^(position_down - 14), and 2^-22 of the triangle's extent. Only pixels that
 * are alive are shaded. A pixel costs the weights (weights.h), 12 multiplications, etch_unit_q14
 * and the shade function: 3170 instructions (4080 cycles) on Cortex-M0+ with one directional lamp
 * in etch_shade_phong, 1260 (1630) of them in that. */
etch_stage_function etch_stage_phong;

#endif
