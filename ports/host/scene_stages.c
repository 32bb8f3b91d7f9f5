/* ports/host/scene_stages.c: a state to its list of stages, in the order of the pipeline. Called by
 * scene_staged.c. */
#include "scene_stages.h"

#include "../../core/draw/mesh_phong.h"

static void add_color(struct etch_scene_builder *b)
{
    const struct etch_scene_state *state = &b->staged->state;

    if (state->shade == 1) {
        etch_scene_add_varyings(b, etch_varying_flat, etch_line_varying_flat);
        ETCH_SCENE_ADD(b, etch_source_flat, NULL);
    } else if (state->persp != 0 && b->staged->differs.w && b->staged->differs.color) {
        etch_scene_add_varying(b, etch_varying_color_perspective);
        ETCH_SCENE_ADD(b, etch_source_color_perspective, NULL);
    } else {
        etch_scene_add_varyings(b, etch_varying_color, etch_line_varying_color);
        etch_scene_add_varyings(b, etch_varying_alpha, etch_line_varying_alpha);
        ETCH_SCENE_ADD(b, etch_source_color, NULL);
        ETCH_SCENE_ADD(b, etch_source_alpha, NULL);
    }
    if (state->shade == 2) {
        etch_scene_add_varying(b, etch_varying_shade);
        ETCH_SCENE_ADD(b, etch_stage_phong, b->staged->phong);
    }
}

static void add_texture(struct etch_scene_builder *b)
{
    static const struct etch_scene_stage_name environments[] = {
        {NULL, NULL},
        ETCH_SCENE_STAGE_NAME(etch_stage_texture_replace),
        ETCH_SCENE_STAGE_NAME(etch_stage_texture_modulate),
        ETCH_SCENE_STAGE_NAME(etch_stage_texture_decal),
    };
    static const struct etch_scene_stage_name sources[] = {
        ETCH_SCENE_STAGE_NAME(etch_source_texture_perspective),
        ETCH_SCENE_STAGE_NAME(etch_source_texture_blocks16),
        ETCH_SCENE_STAGE_NAME(etch_source_texture_perspective),
        ETCH_SCENE_STAGE_NAME(etch_source_texture_blocks8),
    };
    const struct etch_scene_state *state = &b->staged->state;

    if (state->tex == 0) {
        return;
    }
    if (state->persp != 0 && b->staged->differs.w) {
        etch_scene_add_varying(b, etch_varying_texture_perspective);
        etch_scene_add_stage(b, sources[state->mode], NULL);
    } else {
        etch_scene_add_varying(b, etch_varying_texture);
        ETCH_SCENE_ADD(b, etch_source_texture, NULL);
    }
    etch_scene_add_stage(b, environments[state->tex], &b->staged->sampler);
    for (int part = 0; part < ETCH_SCENE_SAMPLING_PARTS; part++) {
        const char *name = etch_scene_sampling_name(&b->staged->sampling, part);

        if (name != NULL) {
            etch_scene_add_name(b, name);
        }
    }
}

static void add_fog(struct etch_scene_builder *b)
{
    struct etch_scene_staged *s = b->staged;
    const uint8_t *rgb = s->state.fog_color;

    if (s->state.fog == 1) {
        (void)etch_fog_linear_init(&s->linear, s->state.fog_start, s->state.fog_end, rgb[0], rgb[1],
                                   rgb[2]);
        ETCH_SCENE_ADD(b, etch_stage_fog_linear, &s->linear);
    } else if (s->state.fog == 2) {
        (void)etch_fog_exponential_init(&s->exponential, s->state.fog_density, rgb[0], rgb[1],
                                        rgb[2]);
        ETCH_SCENE_ADD(b, etch_stage_fog_exponential, &s->exponential);
    }
}

/* Tests stand before colours, unless the alpha test has to come first. */
void etch_scene_staged_build(struct etch_scene_staged *staged)
{
    struct etch_scene_builder b = {staged, 0, 0, 0};
    const struct etch_scene_state *state = &staged->state;

    etch_scene_add_name(&b, "etch_kernel_staged");
    if (state->ztest != 0 || state->fog != 0) {
        etch_scene_add_varyings(&b, etch_varying_depth, etch_line_varying_depth);
        ETCH_SCENE_ADD(&b, etch_source_depth, NULL);
    }
    if (state->atest == 0) {
        etch_scene_add_tests(&b);
    }
    add_color(&b);
    add_texture(&b);
    add_fog(&b);
    if (state->atest != 0) {
        staged->alpha.reference = state->atest_reference;
        ETCH_SCENE_ADD(&b, etch_stage_alpha_gequal, &staged->alpha);
        etch_scene_add_tests(&b);
    }
    etch_scene_add_output(&b);
    staged->pipeline = (struct etch_scene_pipeline){
        .shade = state->shade == 1,
        .ztest = state->ztest,
        .zwrite = state->zwrite,
        .kernel = {etch_kernel_staged, etch_kernel_staged},
        .name = {staged->names[0], staged->names[1]},
        .staged = staged,
        .texture = state->tex != 0 ? &etch_perspective_exact : NULL,
    };
}
