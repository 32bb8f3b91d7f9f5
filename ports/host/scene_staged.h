/* ports/host/scene_staged.h: pipelines of stages, for the states that no fused kernel draws. */
#ifndef ETCH_HOST_SCENE_STAGED_H
#define ETCH_HOST_SCENE_STAGED_H

#include "../../core/draw/line_staged.h"
#include "../../core/draw/mesh_shaded.h"
#include "../../core/draw/staged.h"
#include "../../core/fragment/blend.h"
#include "../../core/fragment/fog.h"
#include "../../core/fragment/logic.h"
#include "../../core/fragment/phong.h"
#include "../../core/fragment/source_blocks.h"
#include "../../core/fragment/stencil.h"
#include "../../core/fragment/test.h"
#include "../../core/fragment/write.h"
#include "scene_steps.h"

enum {
    ETCH_SCENE_STAGES = 20,
    ETCH_SCENE_VARYINGS = 6
};

/* A pipeline and what its stages read; [1] is for rgb565_swapped. */
struct etch_scene_staged {
    struct etch_scene_pipeline pipeline; /* first */
    struct etch_scene_state state;       /* that it was made for */
    struct etch_scene_differs differs;
    const struct etch_scene_texture *of; /* its texture, NULL without */
    const struct etch_phong *phong;      /* NULL without */

    etch_varying *varyings[ETCH_SCENE_VARYINGS + 1];
    etch_line_varying *line_varyings[ETCH_SCENE_VARYINGS + 1]; /* of lines and points */
    struct etch_stage stages[2][ETCH_SCENE_STAGES + 1];
    struct etch_alpha_test alpha;
    struct etch_stencil stencil;
    struct etch_blend_constant constant;
    struct etch_color_mask mask;
    struct etch_fog_linear linear;
    struct etch_fog_exponential exponential;
    struct etch_scene_sampling sampling;
    struct etch_sampler sampler; /* of the triangle in hand */
    char names[2][800];          /* of stages, with blanks between */
};

/* Draws one triangle; the vertices are etch_texture_vertex if `differs` says w or there is a
 * texture. */
void etch_scene_staged_draw(struct etch_scene_run *run, struct etch_scene_staged *staged,
                            const struct etch_vertex *const v[3]);

/* Fills in data, varyings and stages from state, differs and sampling. */
void etch_scene_staged_build(struct etch_scene_staged *staged);

/* Copies vertices to change them; those of a mesh under `state shade phong` have normals. */
void etch_scene_vertices_take(struct etch_shade_vertex out[3],
                              const struct etch_texture_vertex *const v[3], bool with_normals);

#endif
