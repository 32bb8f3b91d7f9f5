/* ports/host/scene_answers.c: select and feedback, which print what the objects before them are
 * made of. scene.c finds them by name; they draw nothing. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../core/fragment/flat.h"
#include "scene_answers.h"
#include "scene_elements.h"
#include "scene_mesh.h"

static bool is(const struct etch_scene_step *step, const char *name)
{
    return strcmp(step->statement->name, name) == 0;
}

static void assemble_ctri(const struct etch_scene *scene, const struct etch_scene_step *step,
                          struct etch_sink *sink)
{
    const struct etch_rect frame = {0, 0, scene->width, scene->height};
    struct etch_assembly assembly = {.cull = step->of.clip_triangle.cull, .sink = sink};

    (void)etch_viewport_init(&assembly.viewport, frame);
    etch_assemble_textured(&assembly, step->of.clip_triangle.v);
}

static void assemble_tri(const struct etch_scene_step *step, struct etch_sink *sink)
{
    const struct etch_texture_vertex *v = step->of.triangle.v;
    const struct etch_vertex *const corners[3] = {&v[0].at, &v[1].at, &v[2].at};

    if (etch_cull_keeps(step->of.triangle.cull, corners)) {
        sink->triangle(sink, corners);
    }
}

/* Hands a step's primitives to the sink; false if it is none of the objects that have some. */
static bool assemble(const struct etch_scene *scene, const struct etch_scene_step *step,
                     struct etch_sink *sink)
{
    if (is(step, "mesh")) {
        etch_scene_mesh_assemble(step->of.mesh, sink);
    } else if (is(step, "ctri")) {
        assemble_ctri(scene, step, sink);
    } else if (is(step, "tri")) {
        assemble_tri(step, sink);
    } else if (is(step, "list")) {
        etch_scene_elements_assemble(step, sink);
    } else {
        return false;
    }
    return true;
}

/* ---- select ---------------------------------------------------------------------------------- */

static void ignore_line(struct etch_sink *sink, const struct etch_vertex *const v[2])
{
    (void)sink, (void)v;
}

static void ignore_point(struct etch_sink *sink, const struct etch_vertex *v)
{
    (void)sink, (void)v;
}

const char *etch_scene_name_objects(const struct etch_scene *scene, struct etch_name_sink *names,
                                    const uint16_t *wanted)
{
    const char *kind = "nothing";

    names->sink.line = ignore_line;
    names->sink.point = ignore_point;
    for (size_t i = 0, n = 0; i < scene->count && n < UINT16_MAX; i++) {
        names->name = (uint16_t)(n + 1);
        n += assemble(scene, &scene->step[i], &names->sink);
        if (wanted != NULL && *wanted == n && n == names->name) {
            kind = scene->step[i].statement->name;
        }
    }
    return kind;
}

/* x y [r g b]: which object is nearest there, said or shown */
static bool read_select(struct etch_scene_reader *reader,
                        const struct etch_scene_statement *statement)
{
    const struct etch_scene *scene = reader->scene;
    struct etch_select select;
    const char *kind;
    int64_t x, y;

    (void)statement;
    if (!etch_text_integer(&reader->text, "x", 0, scene->width - 1, &x) ||
        !etch_text_integer(&reader->text, "y", 0, scene->height - 1, &y)) {
        return false;
    }
    if (etch_text_more(&reader->text)) {
        return etch_scene_read_selected(reader, (int16_t)x, (int16_t)y);
    }
    (void)etch_select_init(&select, (int16_t)x, (int16_t)y, etch_kernel_flat_less);
    kind = etch_scene_name_objects(scene, &select.names, &select.name);
    (void)printf("select %d %d: %d %s\n", (int)x, (int)y, (int)select.name, kind);
    return true;
}

/* ---- feedback ---------------------------------------------------------------------------------
 */

static void print_primitive(const struct etch_feedback_primitive *p)
{
    static const char *const names[] = {"", "point", "line", "triangle"};

    (void)printf("feedback %s", names[p->size]);
    for (int i = 0; i < p->size; i++) {
        const struct etch_vertex *v = &p->v[i];

        (void)printf("  %d %d %u %d %d %d %d", (int)v->x_q8, (int)v->y_q8,
                     (unsigned)((v->z_q16 + UINT32_C(0x8000)) >> 16), v->r, v->g, v->b, v->a);
    }
    (void)printf("\n");
}

static void print_primitives(const struct etch_feedback *f)
{
    for (uint32_t i = 0; i < f->count; i++) {
        print_primitive(&f->primitive[i]);
    }
}

/* [r g b  r g b]: the primitives of the object before, counted first, then kept and printed, or
 * drawn. */
static bool read_feedback(struct etch_scene_reader *reader,
                          const struct etch_scene_statement *statement)
{
    const struct etch_scene *scene = reader->scene;
    struct etch_feedback_primitive *primitive;
    struct etch_feedback f;
    bool ok = true;

    (void)statement;
    etch_feedback_init(&f, NULL, 0);
    if (scene->count == 0 || reader->elements != NULL ||
        !assemble(scene, &scene->step[scene->count - 1], &f.sink)) {
        return etch_text_fail(&reader->text, "feedback follows a mesh, a list, a tri or a ctri");
    }
    primitive = calloc(f.count + 1, sizeof *primitive);
    if (primitive == NULL) {
        return etch_text_fail(&reader->text, "out of memory");
    }
    etch_feedback_init(&f, primitive, f.count);
    (void)assemble(scene, &scene->step[scene->count - 1], &f.sink);
    if (etch_text_more(&reader->text)) {
        ok = etch_scene_read_fed_back(reader, &f);
    } else {
        print_primitives(&f);
    }
    free(primitive);
    return ok;
}

const struct etch_scene_statement etch_scene_answer_statements[] = {
    {"select", read_select, NULL, NULL, NULL},
    {"feedback", read_feedback, NULL, NULL, NULL},
    {NULL, NULL, NULL, NULL, NULL},
};
