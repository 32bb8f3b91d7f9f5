/* ports/host/scene_triangles.c: tri and ctri. scene.c finds them by name, scene_draw.c calls
 * what they append. */
#include "scene_facts.h"
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

bool etch_scene_read_position(struct etch_scene_reader *reader, const char *name, int32_t *q8)
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

    if (!etch_scene_read_position(reader, "x", &v->x_q8) ||
        !etch_scene_read_position(reader, "y", &v->y_q8) ||
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

/* Paints a triangle on the screen with whatever its pipeline is. */
static void paint(struct etch_scene_run *run, const struct etch_scene_pipeline *pipeline,
                  const struct etch_texture_vertex *const v[3], const struct etch_texture *texture)
{
    const struct etch_vertex *const corners[3] = {&v[0]->at, &v[1]->at, &v[2]->at};

    if (run->collect != NULL) {
        run->collect->triangle(run->collect, corners);
        return;
    }
    if (run->stats != NULL) {
        run->stats->triangles++;
    }
    if (pipeline->texture != NULL || pipeline->staged != NULL) {
        etch_scene_paint_texture(run, pipeline, v, texture);
    } else if (run->pass != NULL) {
        etch_scene_pass_triangle(run, pipeline, corners);
    } else {
        etch_scene_facts_triangle(run, pipeline, corners);
        etch_scene_painter(run, pipeline)(&run->surface, corners, etch_scene_kernel(run, pipeline));
    }
}

static void draw_tri(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct etch_texture_vertex *v = step->of.triangle.v;
    const struct etch_vertex *const corners[3] = {&v[0].at, &v[1].at, &v[2].at};
    const struct etch_texture_vertex *const wide[3] = {&v[0], &v[1], &v[2]};

    if (etch_cull_keeps(step->of.triangle.cull, corners)) {
        paint(run, step->pipeline, wide, &step->of.triangle.texture);
    }
}

/* The state, for what has been read; and its texture if a fused kernel draws it. */
static bool read_pipeline(struct etch_scene_reader *reader, struct etch_scene_step *step,
                          struct etch_scene_differs differs, struct etch_texture *texture)
{
    step->pipeline = etch_scene_read_triangle_pipeline(reader, differs);
    return step->pipeline != NULL &&
           (step->pipeline->texture == NULL || step->pipeline->staged != NULL ||
            etch_scene_take_texture(reader, texture));
}

static bool read_tri(struct etch_scene_reader *reader, const struct etch_scene_statement *statement)
{
    struct etch_scene_step *step = etch_scene_append(reader, statement);
    struct etch_scene_differs differs = {false, false};

    for (int i = 0; step != NULL && i < 3; i++) {
        const struct etch_texture_vertex *v = step->of.triangle.v;

        if (!read_vertex(reader, &step->of.triangle.v[i])) {
            return false;
        }
        differs.w |= v[i].w != v[0].w;
        differs.color |= v[i].at.r != v[0].at.r || v[i].at.g != v[0].at.g ||
                         v[i].at.b != v[0].at.b || v[i].at.a != v[0].at.a;
    }
    if (step == NULL) {
        return false;
    }
    step->of.triangle.cull = etch_scene_cull(&reader->state);
    return read_pipeline(reader, step, differs, &step->of.triangle.texture);
}

/* X Y Z W r g b a u v */
static bool read_clip_vertex(struct etch_scene_reader *reader, struct etch_clip_texture_vertex *v)
{
    return etch_text_q16(&reader->text, "x", &v->at.x) &&
           etch_text_q16(&reader->text, "y", &v->at.y) &&
           etch_text_q16(&reader->text, "z", &v->at.z) &&
           etch_text_q16(&reader->text, "w", &v->at.w) &&
           read_rgba(reader, &v->at.r, &v->at.g, &v->at.b, &v->at.a) &&
           etch_text_q16(&reader->text, "u", &v->u) && etch_text_q16(&reader->text, "v", &v->v);
}

/* What the vertex stage hands the triangles of a ctri to. */
struct sink {
    struct etch_sink sink; /* first */
    struct etch_scene_run *run;
    const struct etch_scene_step *step;
};

static void take(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    const struct sink *s = (const struct sink *)(const void *)sink;
    const struct etch_texture_vertex *const wide[3] = {(const void *)v[0], (const void *)v[1],
                                                       (const void *)v[2]};

    paint(s->run, s->step->pipeline, wide, &s->step->of.clip_triangle.texture);
}

static void draw_ctri(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    struct sink sink = {{take, NULL, NULL}, run, step};
    const struct etch_rect frame = {0, 0, run->scene->width, run->scene->height};
    struct etch_assembly assembly = {.cull = step->of.clip_triangle.cull,
                                     .flat = step->pipeline->shade != 0,
                                     .sink = &sink.sink};

    (void)etch_viewport_init(&assembly.viewport, frame);
    etch_assemble_textured(&assembly, step->of.clip_triangle.v);
}

static bool read_ctri(struct etch_scene_reader *reader,
                      const struct etch_scene_statement *statement)
{
    struct etch_scene_step *step = etch_scene_append(reader, statement);
    struct etch_scene_differs differs = {false, false};

    for (int i = 0; step != NULL && i < 3; i++) {
        struct etch_clip_texture_vertex *v = step->of.clip_triangle.v;

        if (!read_clip_vertex(reader, &v[i])) {
            return false;
        }
        differs.w |= v[i].at.w != v[0].at.w;
        differs.color |= v[i].at.r != v[0].at.r || v[i].at.g != v[0].at.g ||
                         v[i].at.b != v[0].at.b || v[i].at.a != v[0].at.a;
    }
    if (step == NULL) {
        return false;
    }
    step->of.clip_triangle.cull = etch_scene_cull(&reader->state);
    return read_pipeline(reader, step, differs, &step->of.clip_triangle.texture);
}

const struct etch_scene_statement etch_scene_triangle_statements[] = {
    {"tri", read_tri, draw_tri, "etch_cull_keeps", NULL},
    {"ctri", read_ctri, draw_ctri, "etch_assemble_textured", NULL},
    {NULL, NULL, NULL, NULL, NULL},
};
