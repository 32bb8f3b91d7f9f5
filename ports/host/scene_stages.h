/* ports/host/scene_stages.h: lists of stages as they grow, for the files that know a part of them;
 * no part of the API. */
#ifndef ETCH_HOST_SCENE_STAGES_H
#define ETCH_HOST_SCENE_STAGES_H

#include "scene_staged.h"

/* The lists for both byte orders, of triangles and of lines. */
struct etch_scene_builder {
    struct etch_scene_staged *staged;
    int varyings, line_varyings, stages;
};

struct etch_scene_stage_name {
    etch_stage_function *run; /* or NULL: no stage */
    const char *name;
};
#define ETCH_SCENE_STAGE_NAME(stage)                                                               \
    {                                                                                              \
        stage, #stage                                                                              \
    }

/* Appends to the lists. The first is for triangles alone, the second for lines too. */
void etch_scene_add_varying(struct etch_scene_builder *b, etch_varying *varying);
void etch_scene_add_varyings(struct etch_scene_builder *b, etch_varying *varying,
                             etch_line_varying *of_line);
void etch_scene_add_stage(struct etch_scene_builder *b, struct etch_scene_stage_name stage,
                          const void *data);
/* .. one that depends on the byte order, */
void etch_scene_add_order(struct etch_scene_builder *b, struct etch_scene_stage_name stage,
                          struct etch_scene_stage_name swapped);
/* .. and a name of what is linked beside the stages. */
void etch_scene_add_name(struct etch_scene_builder *b, const char *name);

#define ETCH_SCENE_ADD(b, stage, data)                                                             \
    etch_scene_add_stage(b, (struct etch_scene_stage_name)ETCH_SCENE_STAGE_NAME(stage), data)
#define ETCH_SCENE_ADD_ORDER(b, stage)                                                             \
    etch_scene_add_order(b, (struct etch_scene_stage_name)ETCH_SCENE_STAGE_NAME(stage),            \
                         (struct etch_scene_stage_name)ETCH_SCENE_STAGE_NAME(stage##_swapped))

/* Parts of the list: stencil and depth, of which what passed the first waits for the second; and
 * blending, raster operations, masks and writing. */
void etch_scene_add_tests(struct etch_scene_builder *b);
void etch_scene_add_output(struct etch_scene_builder *b);

#endif
