/* ports/host/scene_mesh.c: the mesh statement. scene.c finds it by name. A mesh is transformed
 * and lit when it is read (scene_mesh_stage.c), and only rasterised when it is drawn: once for
 * every strip. */
#include "scene_mesh.h"

#include <stdlib.h>

#include "array.h"
#include "scene_lines.h"

/* An empty mesh that the scene owns. */
static struct etch_scene_mesh *new_mesh(struct etch_scene_reader *reader)
{
    struct etch_scene *scene = reader->scene;
    struct etch_scene_mesh *mesh = calloc(1, sizeof *mesh);
    void *list = scene->mesh;

    if (mesh == NULL ||
        !etch_array_grow(&list, &scene->mesh_capacity, scene->mesh_count, sizeof *scene->mesh)) {
        free(mesh);
        (void)etch_text_fail(&reader->text, "out of memory");
        return NULL;
    }
    scene->mesh = list;
    scene->mesh[scene->mesh_count++] = mesh;
    return mesh;
}

/* The sink of a mesh whose vertices are wide: with a texture, or shaded by pixels. */
struct wide_sink {
    struct etch_sink sink; /* first */
    struct etch_scene_run *run;
    const struct etch_scene_step *step;
};

static void paint_wide(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    const struct wide_sink *s = (const void *)sink;
    const struct etch_texture_vertex *const wide[3] = {(const void *)v[0], (const void *)v[1],
                                                       (const void *)v[2]};

    if (s->run->stats != NULL) {
        s->run->stats->triangles++;
    }
    etch_scene_paint_texture(s->run, s->step->pipeline, wide, &s->step->of.mesh->texture);
}

static void draw_wide(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    struct wide_sink sink = {{.triangle = paint_wide}, run, step};

    etch_scene_mesh_assemble(step->of.mesh, &sink.sink);
}

static void draw_mesh(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    struct etch_scene_sink sink;

    etch_scene_sink_init(&sink, run, step->pipeline);
    etch_scene_mesh_assemble(step->of.mesh,
                             run->collect != NULL ? run->collect : &sink.raster.sink);
}

static void draw_wires(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    struct etch_scene_line_sink sink;

    etch_scene_line_sink_init(&sink, run, step);
    etch_scene_mesh_assemble(step->of.mesh, &sink.sink);
}

/* How a mesh is drawn, by [textured][lit, lamps, phong]. */
#define TRANSFORM "etch_mesh_transform etch_mesh_assemble "
#define VARYING "etch_mesh_transform_varying etch_mesh_assemble_varying "
static const struct etch_scene_statement statements[2][3] = {
    {{"mesh", NULL, draw_mesh, TRANSFORM "etch_vertex_lit", NULL},
     {"mesh", NULL, draw_mesh, TRANSFORM "etch_vertex_shaded", NULL},
     {"mesh", NULL, draw_wide, VARYING "etch_vertex_normal", NULL}},
    {{"mesh", NULL, draw_wide, VARYING "etch_vertex_textured etch_vertex_lit", NULL},
     {"mesh", NULL, draw_wide, VARYING "etch_vertex_textured etch_vertex_shaded", NULL},
     {"mesh", NULL, draw_wide, VARYING "etch_vertex_textured etch_vertex_normal", NULL}},
};

/* With a primitive function, by [shrink, wireframe][lit, lamps]. */
#define PRIMITIVE "etch_mesh_primitive_init etch_mesh_primitive_triangles "
static const struct etch_scene_statement by_primitive[2][2] = {
    {{"mesh", NULL, draw_mesh, PRIMITIVE "etch_assemble_triangle etch_vertex_lit", NULL},
     {"mesh", NULL, draw_mesh, PRIMITIVE "etch_assemble_triangle etch_vertex_shaded", NULL}},
    {{"mesh", NULL, draw_wires, PRIMITIVE "etch_assemble_line etch_vertex_lit", NULL},
     {"mesh", NULL, draw_wires, PRIMITIVE "etch_assemble_line etch_vertex_shaded", NULL}},
};

static bool read_primitive_pipeline(struct etch_scene_reader *reader, struct etch_scene_step *step)
{
    const uint8_t kind = reader->primitive.kind;

    if (reader->state.tex != 0 || reader->state.shade == 2) {
        return etch_text_fail(&reader->text, "\"primitive\" hands on colours: no \"state tex\", no "
                                             "\"state shade phong\"");
    }
    step->statement = &by_primitive[kind - 1][reader->view.lamps];
    if (kind == ETCH_SCENE_WIREFRAME) {
        return etch_scene_lines_pipeline(reader, step, ETCH_SCENE_LINE);
    }
    step->pipeline = etch_scene_read_pipeline(reader);
    return step->pipeline != NULL;
}

/* The pipeline for the state, which shades by pixels with this mesh's lights. */
static bool read_pipeline(struct etch_scene_reader *reader, struct etch_scene_step *step,
                          struct etch_scene_mesh *mesh)
{
    const bool by_pixels = reader->state.shade == 2;
    const int light = by_pixels ? 2 : etch_scene_mesh_has_lamps(&reader->view) ? 1 : 0;

    mesh->primitive = reader->primitive;
    if (mesh->primitive.kind != 0) {
        return read_primitive_pipeline(reader, step);
    }
    reader->phong = by_pixels ? &mesh->phong : NULL;
    step->pipeline = etch_scene_read_pipeline(reader);
    reader->phong = NULL;
    if (step->pipeline == NULL) {
        return false;
    }
    step->statement = &statements[reader->state.tex != 0][light];
    return step->pipeline->texture == NULL || step->pipeline->staged != NULL ||
           etch_scene_take_texture(reader, &mesh->texture);
}

static bool read_mesh(struct etch_scene_reader *reader,
                      const struct etch_scene_statement *statement)
{
    struct etch_scene_step *step = etch_scene_append(reader, statement);
    struct etch_scene_mesh *mesh = step != NULL ? new_mesh(reader) : NULL;
    struct etch_text text;
    const char *path, *name;

    if (mesh == NULL) {
        return false;
    }
    step->of.mesh = mesh;
    path = etch_scene_path(reader, &name);
    if (path == NULL || !read_pipeline(reader, step, mesh)) {
        return false;
    }
    return etch_text_open_named(&text, path, name, &reader->text) &&
           etch_obj_read(&mesh->obj, &text) && etch_scene_mesh_prepare(reader, mesh);
}

void etch_scene_mesh_free(struct etch_scene_mesh *mesh)
{
    etch_obj_close(&mesh->obj);
    free(mesh->buffer);
    free(mesh);
}

const struct etch_scene_statement etch_scene_mesh_statements[] = {
    {"mesh", read_mesh, draw_mesh, NULL, NULL},
    {NULL, NULL, NULL, NULL, NULL},
};
