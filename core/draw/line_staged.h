/* draw/line_staged.h: lines and points through stages (fragment/stage.h): fog, tests, stencil,
 * blending, logic operations and masks, as draw/staged.h does for triangles.
 *
 *      static etch_line_varying *const varyings[] = {etch_line_varying_color,
 *                                                    etch_line_varying_alpha, NULL};
 *      static const struct etch_stage stages[] = {
 *          {etch_source_color, NULL}, {etch_source_alpha, NULL},
 *          {etch_stage_read, NULL}, {etch_stage_blend_alpha, NULL}, {etch_stage_write, NULL},
 *          {NULL, NULL}};
 *      const struct etch_line_pipeline trace = {varyings, stages, etch_kernel_staged};
 *      struct etch_staged_planes planes;
 *
 *      etch_line_staged(surface, v, &trace, &planes);
 *      etch_point_staged(surface, v[0], size_q8, etch_point_runs_round, &trace, &planes);
 *
 * The stages are those of triangles; only what sets up their planes is the lines' own. Lines have
 * the pixels and values of draw/line.h, points those of draw/point.h; alpha is within 1/512 + 1/512
 * of the exact value, as a triangle's. Stages, their data and the lists must stay as long as they
 * are drawn with.
 */
#ifndef ETCH_DRAW_LINE_STAGED_H
#define ETCH_DRAW_LINE_STAGED_H

#include "point.h"
#include "staged.h"

/* What a varying of a line is set up from: its pixels and its vertices, of the caller's type. A
 * point is a line of one pixel whose ends are the same vertex. */
struct etch_line_varying_input {
    int16_t x0, y0, x1, y1; /* the pixels of v[0] and v[1] */
    const struct etch_vertex *const *v;
};

/* Sets up what a source reads. Called once for each visible line. One of your own casts `planes` to
 * your struct, which begins with them, and calls etch_line_plane (raster/line_runs.h). */
typedef void etch_line_varying(struct etch_staged_planes *planes,
                               const struct etch_line_varying_input *in);

etch_line_varying etch_line_varying_flat;  /* r g b a of v[0]; instead of the next two */
etch_line_varying etch_line_varying_color; /* r g b, linear along the major axis */
etch_line_varying etch_line_varying_alpha; /* a, likewise; may stand alone */
etch_line_varying etch_line_varying_depth; /* z, likewise */

struct etch_line_pipeline {
    etch_line_varying *const *varyings; /* NULL ends the list */
    const struct etch_stage *stages;
    etch_kernel *kernel; /* etch_kernel_staged, or a kernel of your own over the same planes */
};

/* Draws one line. `planes` is the caller's memory for the time of the call, as for
 * etch_triangle_staged. Every vertex in the ranges of base/sink.h is legal. */
void etch_line_staged(const struct etch_surface *s, const struct etch_vertex *const v[2],
                      const struct etch_line_pipeline *pipeline, struct etch_staged_planes *planes);

/* Draws one point: all of its pixels have the values of v. `runs` is etch_point_runs_square or
 * _round. */
void etch_point_staged(const struct etch_surface *s, const struct etch_vertex *v, uint16_t size_q8,
                       etch_point_runs *runs, const struct etch_line_pipeline *pipeline,
                       struct etch_staged_planes *planes);

/* Draws the rectangle of etch_line_wide (draw/line.h) as two triangles of a pipeline of triangles:
 * each pixel once, also along the edge that they share. */
void etch_line_wide_staged(const struct etch_surface *s, const struct etch_vertex *const v[2],
                           uint16_t width_q8, const struct etch_pipeline *pipeline,
                           struct etch_staged_planes *planes);

#endif
