/* ports/host/scene_stages_output.c: the stages that write: blending, raster operations, masks.
 * scene_stages.c places them. */
#include "scene_stages.h"

/* A raster operation takes the place of blending. */
void etch_scene_add_output(struct etch_scene_builder *b)
{
    static const struct etch_scene_stage_name blends[] = {
        {NULL, NULL},
        ETCH_SCENE_STAGE_NAME(etch_stage_blend_alpha),
        ETCH_SCENE_STAGE_NAME(etch_stage_blend_add),
        ETCH_SCENE_STAGE_NAME(etch_stage_blend_multiply),
        ETCH_SCENE_STAGE_NAME(etch_stage_blend_add_alpha),
        ETCH_SCENE_STAGE_NAME(etch_stage_blend_constant),
    };
    static const struct etch_scene_stage_name operations[] = {
        {NULL, NULL},
        ETCH_SCENE_STAGE_NAME(etch_stage_logic_clear),
        ETCH_SCENE_STAGE_NAME(etch_stage_logic_and),
        ETCH_SCENE_STAGE_NAME(etch_stage_logic_and_reverse),
        ETCH_SCENE_STAGE_NAME(etch_stage_logic_copy),
        ETCH_SCENE_STAGE_NAME(etch_stage_logic_and_inverted),
        ETCH_SCENE_STAGE_NAME(etch_stage_logic_noop),
        ETCH_SCENE_STAGE_NAME(etch_stage_logic_xor),
        ETCH_SCENE_STAGE_NAME(etch_stage_logic_or),
        ETCH_SCENE_STAGE_NAME(etch_stage_logic_nor),
        ETCH_SCENE_STAGE_NAME(etch_stage_logic_equiv),
        ETCH_SCENE_STAGE_NAME(etch_stage_logic_invert),
        ETCH_SCENE_STAGE_NAME(etch_stage_logic_or_reverse),
        ETCH_SCENE_STAGE_NAME(etch_stage_logic_copy_inverted),
        ETCH_SCENE_STAGE_NAME(etch_stage_logic_or_inverted),
        ETCH_SCENE_STAGE_NAME(etch_stage_logic_nand),
        ETCH_SCENE_STAGE_NAME(etch_stage_logic_set),
    };
    struct etch_scene_staged *s = b->staged;
    const struct etch_scene_state *state = &s->state;

    if (state->blend != 0 || state->logic != 0 || state->color_mask != UINT16_MAX) {
        ETCH_SCENE_ADD_ORDER(b, etch_stage_read);
    }
    s->constant.alpha = state->blend_alpha;
    s->mask.bits = state->color_mask;
    etch_scene_add_stage(b, state->logic != 0 ? operations[state->logic] : blends[state->blend],
                         &s->constant);
    if (state->color_mask != UINT16_MAX) {
        ETCH_SCENE_ADD(b, etch_stage_color_mask, &s->mask);
    }
    ETCH_SCENE_ADD_ORDER(b, etch_stage_write);
}
