/* ports/host/scene_stages.c: a state to its list of stages, in the order of the pipeline. Called by
 * scene_staged.c. */
#include <stdio.h>
#include <string.h>

#include "../../core/draw/mesh_phong.h"
#include "scene_staged.h"

/* The lists for both byte orders, as they grow. */
struct builder {
    struct etch_scene_staged *staged;
    int varyings, line_varyings, stages;
};

static void add_varying(struct builder *b, etch_varying *varying)
{
    b->staged->varyings[b->varyings++] = varying;
}

/* One that lines have too. */
static void add_varyings(struct builder *b, etch_varying *varying, etch_line_varying *of_line)
{
    add_varying(b, varying);
    b->staged->line_varyings[b->line_varyings++] = of_line;
}

static void add_name(char *names, size_t size, const char *name)
{
    const size_t used = strlen(names);

    (void)snprintf(names + used, size - used, "%s%s", used != 0 ? " " : "", name);
}

/* Appends to both lists; what depends on the byte order is replaced in the second. */
static void add_both(struct builder *b, const void *data, etch_stage_function *run,
                     const char *name, etch_stage_function *swapped, const char *swapped_name)
{
    struct etch_scene_staged *s = b->staged;

    s->stages[0][b->stages] = (struct etch_stage){run, data};
    s->stages[1][b->stages] = (struct etch_stage){swapped, data};
    add_name(s->names[0], sizeof s->names[0], name);
    add_name(s->names[1], sizeof s->names[1], swapped_name);
    b->stages++;
}

#define ADD(b, stage, data) add_both(b, data, stage, #stage, stage, #stage)
#define ADD_SWAPPED(b, stage) add_both(b, NULL, stage, #stage, stage##_swapped, #stage "_swapped")

struct named {
    etch_stage_function *run;
    const char *name;
};
#define NAMED(stage)                                                                               \
    {                                                                                              \
        stage, #stage                                                                              \
    }

static void add_named(struct builder *b, struct named stage, const void *data)
{
    if (stage.run != NULL) {
        add_both(b, data, stage.run, stage.name, stage.run, stage.name);
    }
}

static void add_stencil(struct builder *b)
{
    static const struct named functions[] = {
        NAMED(etch_stage_stencil_never),   NAMED(etch_stage_stencil_less),
        NAMED(etch_stage_stencil_equal),   NAMED(etch_stage_stencil_lequal),
        NAMED(etch_stage_stencil_greater), NAMED(etch_stage_stencil_notequal),
        NAMED(etch_stage_stencil_gequal),  NAMED(etch_stage_stencil_always),
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
    add_named(b, functions[state->stencil - 1], &b->staged->stencil);
}

/* Stencil and depth; what passed the first waits for the second. */
static void add_tests(struct builder *b)
{
    static const struct named functions[] = {
        {NULL, NULL}, /* off */
        NAMED(etch_stage_depth_never),
        NAMED(etch_stage_depth_less),
        NAMED(etch_stage_depth_equal),
        NAMED(etch_stage_depth_lequal),
        NAMED(etch_stage_depth_greater),
        NAMED(etch_stage_depth_notequal),
        NAMED(etch_stage_depth_gequal),
        {NULL, NULL}, /* always */
    };
    const struct etch_scene_state *state = &b->staged->state;

    if (state->stencil != 0) {
        add_stencil(b);
    }
    add_named(b, functions[state->ztest], NULL);
    if (state->stencil != 0) {
        ADD(b, etch_stage_stencil_update, &b->staged->stencil);
    }
    if (state->ztest != 0 && state->zwrite != 0) {
        ADD(b, etch_stage_depth_write, NULL);
    }
}

static void add_color(struct builder *b)
{
    const struct etch_scene_state *state = &b->staged->state;

    if (state->shade == 1) {
        add_varyings(b, etch_varying_flat, etch_line_varying_flat);
        ADD(b, etch_source_flat, NULL);
    } else if (state->persp != 0 && b->staged->differs.w && b->staged->differs.color) {
        add_varying(b, etch_varying_color_perspective);
        ADD(b, etch_source_color_perspective, NULL);
    } else {
        add_varyings(b, etch_varying_color, etch_line_varying_color);
        add_varyings(b, etch_varying_alpha, etch_line_varying_alpha);
        ADD(b, etch_source_color, NULL);
        ADD(b, etch_source_alpha, NULL);
    }
    if (state->shade == 2) {
        add_varying(b, etch_varying_shade);
        ADD(b, etch_stage_phong, b->staged->phong);
    }
}

static void add_texture(struct builder *b)
{
    static const struct named environments[] = {
        {NULL, NULL},
        NAMED(etch_stage_texture_replace),
        NAMED(etch_stage_texture_modulate),
        NAMED(etch_stage_texture_decal),
    };
    static const struct named sources[] = {
        NAMED(etch_source_texture_perspective),
        NAMED(etch_source_texture_blocks16),
        NAMED(etch_source_texture_perspective),
        NAMED(etch_source_texture_blocks8),
    };
    const struct etch_scene_state *state = &b->staged->state;

    if (state->tex == 0) {
        return;
    }
    if (state->persp != 0 && b->staged->differs.w) {
        add_varying(b, etch_varying_texture_perspective);
        add_named(b, sources[state->mode], NULL);
    } else {
        add_varying(b, etch_varying_texture);
        ADD(b, etch_source_texture, NULL);
    }
    add_named(b, environments[state->tex], &b->staged->sampler);
    for (int part = 0; part < ETCH_SCENE_SAMPLING_PARTS; part++) {
        const char *name = etch_scene_sampling_name(&b->staged->sampling, part);

        for (int order = 0; name != NULL && order < 2; order++) {
            add_name(b->staged->names[order], sizeof b->staged->names[order], name);
        }
    }
}

static void add_fog(struct builder *b)
{
    struct etch_scene_staged *s = b->staged;
    const uint8_t *rgb = s->state.fog_color;

    if (s->state.fog == 1) {
        (void)etch_fog_linear_init(&s->linear, s->state.fog_start, s->state.fog_end, rgb[0], rgb[1],
                                   rgb[2]);
        ADD(b, etch_stage_fog_linear, &s->linear);
    } else if (s->state.fog == 2) {
        (void)etch_fog_exponential_init(&s->exponential, s->state.fog_density, rgb[0], rgb[1],
                                        rgb[2]);
        ADD(b, etch_stage_fog_exponential, &s->exponential);
    }
}

/* A raster operation takes the place of blending. */
static void add_output(struct builder *b)
{
    static const struct named blends[] = {
        {NULL, NULL},
        NAMED(etch_stage_blend_alpha),
        NAMED(etch_stage_blend_add),
        NAMED(etch_stage_blend_multiply),
        NAMED(etch_stage_blend_add_alpha),
        NAMED(etch_stage_blend_constant),
    };
    static const struct named operations[] = {
        {NULL, NULL},
        NAMED(etch_stage_logic_clear),
        NAMED(etch_stage_logic_and),
        NAMED(etch_stage_logic_and_reverse),
        NAMED(etch_stage_logic_copy),
        NAMED(etch_stage_logic_and_inverted),
        NAMED(etch_stage_logic_noop),
        NAMED(etch_stage_logic_xor),
        NAMED(etch_stage_logic_or),
        NAMED(etch_stage_logic_nor),
        NAMED(etch_stage_logic_equiv),
        NAMED(etch_stage_logic_invert),
        NAMED(etch_stage_logic_or_reverse),
        NAMED(etch_stage_logic_copy_inverted),
        NAMED(etch_stage_logic_or_inverted),
        NAMED(etch_stage_logic_nand),
        NAMED(etch_stage_logic_set),
    };
    struct etch_scene_staged *s = b->staged;
    const struct etch_scene_state *state = &s->state;

    if (state->blend != 0 || state->logic != 0 || state->color_mask != UINT16_MAX) {
        ADD_SWAPPED(b, etch_stage_read);
    }
    s->constant.alpha = state->blend_alpha;
    s->mask.bits = state->color_mask;
    add_named(b, state->logic != 0 ? operations[state->logic] : blends[state->blend], &s->constant);
    if (state->color_mask != UINT16_MAX) {
        ADD(b, etch_stage_color_mask, &s->mask);
    }
    ADD_SWAPPED(b, etch_stage_write);
}

/* Tests stand before colours, unless the alpha test has to come first. */
void etch_scene_staged_build(struct etch_scene_staged *staged)
{
    struct builder b = {staged, 0, 0, 0};
    const struct etch_scene_state *state = &staged->state;

    add_name(staged->names[0], sizeof staged->names[0], "etch_kernel_staged");
    add_name(staged->names[1], sizeof staged->names[1], "etch_kernel_staged");
    if (state->ztest != 0 || state->fog != 0) {
        add_varyings(&b, etch_varying_depth, etch_line_varying_depth);
        ADD(&b, etch_source_depth, NULL);
    }
    if (state->atest == 0) {
        add_tests(&b);
    }
    add_color(&b);
    add_texture(&b);
    add_fog(&b);
    if (state->atest != 0) {
        staged->alpha.reference = state->atest_reference;
        ADD(&b, etch_stage_alpha_gequal, &staged->alpha);
        add_tests(&b);
    }
    add_output(&b);
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
