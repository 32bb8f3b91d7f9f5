/* ports/host/scene_stages_test.c: the stages of stencil and depth tests. scene_stages.c places
 * them. */
#include "scene_stages.h"

static void add_stencil(struct etch_scene_builder *b)
{
    static const struct etch_scene_stage_name functions[] = {
        ETCH_SCENE_STAGE_NAME(etch_stage_stencil_never),
        ETCH_SCENE_STAGE_NAME(etch_stage_stencil_less),
        ETCH_SCENE_STAGE_NAME(etch_stage_stencil_equal),
        ETCH_SCENE_STAGE_NAME(etch_stage_stencil_lequal),
        ETCH_SCENE_STAGE_NAME(etch_stage_stencil_greater),
        ETCH_SCENE_STAGE_NAME(etch_stage_stencil_notequal),
        ETCH_SCENE_STAGE_NAME(etch_stage_stencil_gequal),
        ETCH_SCENE_STAGE_NAME(etch_stage_stencil_always),
    };
    static etch_stencil_operation *const operations[] = {
        NULL,
        etch_stencil_zero,
        etch_stencil_replace,
        etch_stencil_incr,
        etch_stencil_decr,
        etch_stencil_invert,
        etch_stencil_incr_wrap,
        etch_stencil_decr_wrap,
    };
    const struct etch_scene_state *state = &b->staged->state;

    b->staged->stencil = (struct etch_stencil){state->stencil_reference,
                                               state->stencil_mask,
                                               state->stencil_write,
                                               operations[state->stencil_operation[0]],
                                               operations[state->stencil_operation[1]],
                                               operations[state->stencil_operation[2]]};
    etch_scene_add_stage(b, functions[state->stencil - 1], &b->staged->stencil);
}

void etch_scene_add_tests(struct etch_scene_builder *b)
{
    static const struct etch_scene_stage_name functions[] = {
        {NULL, NULL}, /* off */
        ETCH_SCENE_STAGE_NAME(etch_stage_depth_never),
        ETCH_SCENE_STAGE_NAME(etch_stage_depth_less),
        ETCH_SCENE_STAGE_NAME(etch_stage_depth_equal),
        ETCH_SCENE_STAGE_NAME(etch_stage_depth_lequal),
        ETCH_SCENE_STAGE_NAME(etch_stage_depth_greater),
        ETCH_SCENE_STAGE_NAME(etch_stage_depth_notequal),
        ETCH_SCENE_STAGE_NAME(etch_stage_depth_gequal),
        {NULL, NULL}, /* always */
    };
    const struct etch_scene_state *state = &b->staged->state;

    if (state->stencil != 0) {
        add_stencil(b);
    }
    etch_scene_add_stage(b, functions[state->ztest], NULL);
    if (state->stencil != 0) {
        ETCH_SCENE_ADD(b, etch_stage_stencil_update, &b->staged->stencil);
    }
    if (state->ztest != 0 && state->zwrite != 0) {
        ETCH_SCENE_ADD(b, etch_stage_depth_write, NULL);
    }
}
