/* ports/host/scene_staged.c: which pipeline draws a state: a fused kernel if there is one
 * (scene_pipeline.c), else stages (scene_stages.c); and draws the latter. The statements that read
 * triangles and meshes ask, once a primitive. */
#include "scene_staged.h"

#include <string.h>

void etch_scene_vertices_take(struct etch_shade_vertex out[3],
                              const struct etch_texture_vertex *const v[3], bool with_normals)
{
    for (int i = 0; i < 3; i++) {
        memcpy(&out[i], v[i], with_normals ? sizeof *out : sizeof *v[i]);
    }
}

void etch_scene_staged_draw(struct etch_scene_run *run, struct etch_scene_staged *staged,
                            const struct etch_vertex *const v[3])
{
    struct etch_texture_vertex leveled[3];
    struct etch_shade_vertex whole[3];
    const struct etch_vertex *corners[3] = {v[0], v[1], v[2]};
    struct etch_phong_planes planes;
    const struct etch_pipeline pipeline = {staged->varyings, staged->stages[run->scene->format],
                                           run->stats != NULL ? etch_scene_count
                                                              : etch_kernel_staged};

    run->kernel = etch_kernel_staged;
    if (staged->of != NULL) {
        const struct etch_texture_vertex *const wide[3] = {(const void *)v[0], (const void *)v[1],
                                                           (const void *)v[2]};

        etch_scene_sample_triangle(&staged->sampling, &staged->sampler, leveled, wide);
        etch_scene_vertices_take(whole, wide, staged->phong != NULL);
        for (int i = 0; i < 3; i++) {
            whole[i].at = leveled[i];
            corners[i] = &whole[i].at.at;
        }
    }
    etch_triangle_staged(&run->surface, corners, &pipeline, &planes.staged);
}

/* Whether a fused kernel draws the triangle, and with which one. */
static const struct etch_scene_pipeline *find_fused(const struct etch_scene_reader *reader,
                                                    struct etch_scene_differs differs)
{
    const struct etch_scene_state *state = &reader->state;

    if (state->shade == 2 || (state->tex != 0 && !etch_scene_texture_is_plain(reader))) {
        return NULL;
    }
    if (state->tex == 0 && state->shade == 0 && state->persp != 0 && differs.w && differs.color) {
        return NULL; /* colours in perspective */
    }
    return state->blend != 0 ? etch_scene_pipeline_find_blend(state)
                             : etch_scene_pipeline_find(state);
}

/* What draws exact values, dithered ones or inverse depth: there are no stages for them. */
static const struct etch_scene_pipeline *find_special(struct etch_scene_reader *reader,
                                                      struct etch_scene_differs differs)
{
    const struct etch_scene_state *state = &reader->state;
    const struct etch_scene_pipeline *pipeline = etch_scene_pipeline_find_mode(state);

    if (pipeline == NULL ||
        (state->shade == 0 && state->persp != 0 && differs.w && differs.color)) {
        (void)etch_text_fail(
            &reader->text,
            "each of \"state mode exact\", \"dither on\" and \"depth inverse\" draws colours that "
            "are linear on the screen, with ztest off, less or lequal and no other state");
        return NULL;
    }
    return pipeline;
}

static bool is_same(const struct etch_scene_staged *staged, const struct etch_scene_reader *reader,
                    struct etch_scene_differs differs)
{
    return staged != NULL && memcmp(&staged->state, &reader->state, sizeof reader->state) == 0 &&
           staged->differs.w == differs.w && staged->differs.color == differs.color &&
           (reader->state.tex == 0 || staged->of == reader->texture) &&
           staged->phong == reader->phong;
}

/* The latest pipeline of stages if it still fits, or a new one. */
static const struct etch_scene_pipeline *take_staged(struct etch_scene_reader *reader,
                                                     struct etch_scene_differs differs)
{
    struct etch_scene_staged *staged = reader->staged;

    if (is_same(staged, reader, differs)) {
        return &staged->pipeline;
    }
    staged = etch_scene_data(reader, sizeof *staged);
    if (staged == NULL) {
        return NULL;
    }
    memcpy(&staged->state, &reader->state, sizeof staged->state);
    staged->differs = differs;
    staged->phong = reader->phong;
    if (reader->state.tex != 0) {
        if (!etch_scene_take_sampler(reader, &staged->sampling)) {
            return NULL;
        }
        staged->of = reader->texture;
    }
    etch_scene_staged_build(staged);
    reader->staged = staged;
    return &staged->pipeline;
}

/* The planes that the state's pipeline reads. */
static const struct etch_scene_pipeline *note_planes(struct etch_scene_reader *reader,
                                                     const struct etch_scene_pipeline *pipeline)
{
    if (pipeline != NULL) {
        reader->scene->uses_depth |= reader->state.ztest != 0;
        reader->scene->uses_stencil |= reader->state.stencil != 0;
    }
    return pipeline;
}

/* A fused kernel, or stages. */
static const struct etch_scene_pipeline *find_usual(struct etch_scene_reader *reader,
                                                    struct etch_scene_differs differs)
{
    const struct etch_scene_pipeline *pipeline;

    if (reader->state.tex != 0 && reader->texture == NULL) {
        (void)etch_text_fail(&reader->text, "\"state tex\" is on, but there is no texture");
        return NULL;
    }
    if (reader->state.shade == 2 && reader->phong == NULL) {
        (void)etch_text_fail(&reader->text, "\"state shade phong\" is for meshes: others have no "
                                            "normals");
        return NULL;
    }
    pipeline = find_fused(reader, differs);
    return pipeline != NULL ? pipeline : take_staged(reader, differs);
}

/* Puts the modes that are asked for in place of the scene's, where the state can be drawn in them.
 */
static void take_modes(struct etch_scene_reader *reader, struct etch_scene_differs differs)
{
    const struct etch_scene_modes *modes = reader->scene->modes;
    struct etch_scene_state state = reader->state;
    const bool straight = state.shade != 0 || state.persp == 0 || !differs.w || !differs.color;

    if (modes == NULL || etch_scene_mode_is_special(&state)) {
        return;
    }
    if (state.tex != 0) {
        state.mode = modes->texture;
        state.persp = state.persp != 0 && modes->perspective;
    } else {
        state.mode = modes->exact ? 2 : 0;
        state.dither = modes->dither;
        state.depth = modes->inverse;
        if (!straight || etch_scene_pipeline_find_mode(&state) == NULL) {
            return;
        }
    }
    reader->state = state;
}

const struct etch_scene_pipeline *
etch_scene_read_triangle_pipeline(struct etch_scene_reader *reader,
                                  struct etch_scene_differs differs)
{
    const struct etch_scene_state state = reader->state;
    const struct etch_scene_pipeline *pipeline;

    take_modes(reader, differs);
    if (etch_scene_mode_is_special(&reader->state)) {
        pipeline = find_special(reader, differs);
    } else {
        pipeline = find_usual(reader, differs);
    }
    pipeline = note_planes(reader, pipeline);
    reader->state = state;
    return pipeline;
}

const struct etch_scene_pipeline *etch_scene_read_line_pipeline(struct etch_scene_reader *reader)
{
    const struct etch_scene_differs same = {false, false};
    const struct etch_scene_state state = reader->state;
    const struct etch_scene_pipeline *pipeline;

    reader->state.shade = 0; /* what is flat has equal vertices */
    reader->state.tex = 0;
    reader->state.mode = 0;
    reader->state.dither = 0;
    reader->state.depth = 0;
    pipeline = etch_scene_pipeline_find(&reader->state);
    if (pipeline == NULL) {
        reader->state.shade = state.shade == 1;
        pipeline = take_staged(reader, same);
    }
    reader->state = state;
    return note_planes(reader, pipeline);
}

const struct etch_scene_pipeline *etch_scene_read_pipeline(struct etch_scene_reader *reader)
{
    /* textures have a w; colours are linear on the screen */
    const struct etch_scene_differs differs = {reader->state.tex != 0, false};

    return etch_scene_read_triangle_pipeline(reader, differs);
}
