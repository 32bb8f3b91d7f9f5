/* ports/host/scene_triangles.c: tri and ctri. scene.c finds them by name, scene_draw.c calls
 * what they append. */
#include <string.h>

#include "scene_steps.h"

/* r g b a */
static bool read_rgba(struct etch_scene_reader *reader, uint8_t *r, uint8_t *g, uint8_t *b,
                      uint8_t *a)
{
    return etch_scene_read_byte(reader, "r", r) && etch_scene_read_byte(reader, "g", g) &&
           etch_scene_read_byte(reader, "b", b) && etch_scene_read_byte(reader, "a", a);
}

/* u v */
static bool read_uv(struct etch_scene_reader *reader, struct etch_texture_vertex *v)
{
    return etch_text_q16(&reader->text, "u", &v->u) && etch_text_q16(&reader->text, "v", &v->v);
}

/* A coordinate in 2^-frac px to 1/256 px: to 16.16 exactly, then as every 16.16 is snapped. */
static bool read_position(struct etch_scene_reader *reader, const char *name, int32_t *q8)
{
    const int64_t limit = INT64_C(1) << (15 + reader->frac);
    int64_t value;

    if (!etch_text_integer(&reader->text, name, -limit, limit - 1, &value)) {
        return false;
    }
    *q8 = etch_snap_q8((etch_q16)(value * (INT32_C(1) << (16 - reader->frac))));
    return true;
}

/* x y z w r g b a u v */
static bool read_vertex(struct etch_scene_reader *reader, struct etch_texture_vertex *vertex)
{
    struct etch_vertex *v = &vertex->at;
    int64_t z;
    int32_t w;

    if (!read_position(reader, "x", &v->x_q8) || !read_position(reader, "y", &v->y_q8) ||
        !etch_text_integer(&reader->text, "z", 0, 65535, &z) ||
        !etch_text_q16(&reader->text, "w", &w)) {
        return false;
    }
    if (w <= 0) {
        return etch_text_fail(&reader->text, "w must be greater than 0");
    }
    v->z_q16 = (uint32_t)z << 16;
    vertex->w = (uint32_t)w;
    return read_rgba(reader, &v->r, &v->g, &v->b, &v->a) && read_uv(reader, vertex);
}

static void draw_tri(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct etch_scene_pipeline *pipeline = step->pipeline;
    const struct etch_texture_vertex *v = step->of.triangle.v;
    const struct etch_vertex *const corners[3] = {&v[0].at, &v[1].at, &v[2].at};
    const struct etch_texture_vertex *const textured[3] = {&v[0], &v[1], &v[2]};

    if (!etch_cull_keeps(step->of.triangle.cull, corners)) {
        return;
    }
    if (run->stats != NULL) {
        run->stats->triangles++;
    }
    if (pipeline->texture != NULL) {
        etch_scene_paint_texture(run, pipeline, textured, &step->of.triangle.texture);
    } else {
        etch_scene_painter(run, pipeline)(&run->surface, corners, etch_scene_kernel(run, pipeline));
    }
}

/* The state, for what has been read; and its texture if it has one. */
static bool read_pipeline(struct etch_scene_reader *reader, struct etch_scene_step *step,
                          struct etch_texture *texture)
{
    step->pipeline = etch_scene_read_pipeline(reader);
    return step->pipeline != NULL &&
           (step->pipeline->texture == NULL || etch_scene_take_texture(reader, texture));
}

static bool read_tri(struct etch_scene_reader *reader, const struct etch_scene_statement *statement)
{
    struct etch_scene_step *step = etch_scene_append(reader, statement);

    for (int i = 0; step != NULL && i < 3; i++) {
        if (!read_vertex(reader, &step->of.triangle.v[i])) {
            return false;
        }
    }
    if (step == NULL) {
        return false;
    }
    step->of.triangle.cull = etch_scene_cull(&reader->state);
    return read_pipeline(reader, step, &step->of.triangle.texture);
}

/* X Y Z W r g b a u v; u and v go to `textured` */
static bool read_clip_vertex(struct etch_scene_reader *reader, struct etch_clip_vertex *v,
                             struct etch_texture_vertex *textured)
{
    return etch_text_q16(&reader->text, "x", &v->x) && etch_text_q16(&reader->text, "y", &v->y) &&
           etch_text_q16(&reader->text, "z", &v->z) && etch_text_q16(&reader->text, "w", &v->w) &&
           read_rgba(reader, &v->r, &v->g, &v->b, &v->a) && read_uv(reader, textured);
}

static void draw_ctri(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    struct etch_scene_sink sink;
    const struct etch_rect frame = {0, 0, run->scene->width, run->scene->height};
    struct etch_assembly assembly = {.cull = step->of.clip_triangle.cull,
                                     .flat = step->pipeline->shade != 0,
                                     .sink = &sink.raster.sink};

    etch_scene_sink_init(&sink, run, step->pipeline);
    (void)etch_viewport_init(&assembly.viewport, frame);
    etch_assemble_triangle(&assembly, step->of.clip_triangle.v);
}

static void draw_nothing(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    (void)run, (void)step;
}

static const struct etch_scene_statement projected = {"ctri", NULL, draw_tri,
                                                      "etch_viewport_project", NULL};
static const struct etch_scene_statement rejected = {"ctri", NULL, draw_nothing,
                                                     "etch_viewport_outcode", NULL};

/* Makes a textured ctri, whose coordinates the vertex stage does not carry yet, the tri that it
 * is on the screen. */
static bool project(struct etch_scene_reader *reader, struct etch_scene_step *step,
                    struct etch_texture_vertex textured[3])
{
    const struct etch_rect frame = {0, 0, reader->scene->width, reader->scene->height};
    struct etch_viewport viewport;
    uint8_t all = ETCH_OUT_REJECT, any = 0;

    (void)etch_viewport_init(&viewport, frame);
    for (int i = 0; i < 3; i++) {
        const uint8_t out = etch_viewport_outcode(&viewport, &step->of.clip_triangle.v[i]);

        all &= out;
        any |= out;
    }
    if (all != 0) {
        step->statement = &rejected;
        return true;
    }
    if ((any & ETCH_OUT_CLIP) != 0) {
        return etch_text_fail(&reader->text, "a textured ctri that is to be clipped (near, far, or "
                                             "far outside the frame) is not supported yet");
    }
    for (int i = 0; i < 3; i++) {
        const struct etch_clip_vertex *v = &step->of.clip_triangle.v[i];

        etch_viewport_project(&viewport, v, &textured[i].at);
        textured[i].w = (uint32_t)v->w;
    }
    step->statement = &projected;
    memcpy(step->of.triangle.v, textured, sizeof step->of.triangle.v);
    step->of.triangle.cull = etch_scene_cull(&reader->state);
    return etch_scene_take_texture(reader, &step->of.triangle.texture);
}

static bool read_ctri(struct etch_scene_reader *reader,
                      const struct etch_scene_statement *statement)
{
    struct etch_scene_step *step = etch_scene_append(reader, statement);
    struct etch_texture_vertex textured[3];
    struct etch_texture texture;

    for (int i = 0; step != NULL && i < 3; i++) {
        if (!read_clip_vertex(reader, &step->of.clip_triangle.v[i], &textured[i])) {
            return false;
        }
    }
    if (step == NULL || !read_pipeline(reader, step, &texture)) {
        return false;
    }
    step->of.clip_triangle.cull = etch_scene_cull(&reader->state);
    return step->pipeline->texture == NULL || project(reader, step, textured);
}

const struct etch_scene_statement etch_scene_triangle_statements[] = {
    {"tri", read_tri, draw_tri, "etch_cull_keeps", NULL},
    {"ctri", read_ctri, draw_ctri, "etch_assemble_triangle", NULL},
    {NULL, NULL, NULL, NULL, NULL},
};
