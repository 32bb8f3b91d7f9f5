/* draw/staged.h: triangles through stages (fragment/stage.h): every combination of varyings,
 * texture, tests, stencil, blending, logic operations and masks.
 *
 *      static etch_varying *const varyings[] = {etch_varying_color, etch_varying_alpha, NULL};
 *      static const struct etch_stage stages[] = {
 *          {etch_source_color, NULL}, {etch_source_alpha, NULL},
 *          {etch_stage_read, NULL}, {etch_stage_blend_alpha, NULL}, {etch_stage_write, NULL},
 *          {NULL, NULL}};
 *      const struct etch_pipeline glass = {varyings, stages, etch_kernel_staged};
 *      struct etch_staged_planes planes;
 *
 *      etch_triangle_staged(surface, v, &glass, &planes);
 *
 * A varying is set up only if the pipeline names it, and then evaluated by the source of the same
 * name (fragment/source.h). Stages, their data and the list must stay as long as they are drawn
 * with. Coverage, clipping and ranges are those of draw/triangle.h.
 */
#ifndef ETCH_DRAW_STAGED_H
#define ETCH_DRAW_STAGED_H

#include "../fragment/source.h"
#include "../raster/basis.h"

/* What a varying is set up from. v are the caller's vertices: etch_vertex, or the wider type that
 * the caller and the varying agree on. */
struct etch_varying_input {
    const struct etch_triangle *triangle;
    const struct etch_basis *basis; /* of the triangle, or NULL if it is not near */
    const struct etch_vertex *const *v;
};

/* Sets up what a source reads. Called once for each visible triangle. One of your own casts
 * `planes` to your struct, which begins with them. */
typedef void etch_varying(struct etch_staged_planes *planes, const struct etch_varying_input *in);

etch_varying etch_varying_flat;  /* r g b a of v[0]; instead of the next two */
etch_varying etch_varying_color; /* r g b, linear on the screen */
etch_varying etch_varying_alpha; /* a, linear on the screen; may stand alone */
etch_varying etch_varying_depth; /* z, linear on the screen */

/* These need struct etch_texture_vertex. r g b a in perspective: */
etch_varying etch_varying_color_perspective;
/* u v, linear on the screen and in perspective */
etch_varying etch_varying_texture;
etch_varying etch_varying_texture_perspective;

struct etch_pipeline {
    etch_varying *const *varyings; /* NULL ends the list */
    const struct etch_stage *stages;
    etch_kernel *kernel; /* etch_kernel_staged, or a kernel of your own over the same planes */
};

/* Draws one triangle. `planes` is the caller's memory for the time of the call: a struct
 * etch_staged_planes, or a larger one that begins with it if a varying of the pipeline writes
 * there. Every vertex in the ranges of base/sink.h is legal, with every u, v and w. */
void etch_triangle_staged(const struct etch_surface *s, const struct etch_vertex *const v[3],
                          const struct etch_pipeline *pipeline, struct etch_staged_planes *planes);

/* True if all w are equal (0 counts as 1): then what is linear in space is linear on the screen,
 * and the pipeline without perspective gives the same in less time. */
bool etch_triangle_is_parallel(const struct etch_texture_vertex *const v[3]);

/* ---- the sink ------------------------------------------------------------------------------- */

/* Takes triangles from the vertex stage (base/sink.h) through a pipeline. */
struct etch_staged_sink {
    struct etch_sink sink; /* give &staged.sink to etch_assembly */
    const struct etch_surface *surface;
    const struct etch_pipeline *pipeline;
    struct etch_staged_planes *planes; /* the caller's, as above */
};

/* Fills in all members. The surface may be changed between calls (the next strip). */
void etch_staged_sink_init(struct etch_staged_sink *staged, const struct etch_surface *surface,
                           const struct etch_pipeline *pipeline, struct etch_staged_planes *planes);

#endif
