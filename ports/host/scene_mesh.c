/* ports/host/scene_mesh.c: the mesh statement. scene.c finds it by name. A mesh is transformed
 * and lit when it is read, and only rasterised when it is drawn: once for every strip. */
#include <stdlib.h>

#include "../../core/draw/mesh_varying.h"
#include "array.h"
#include "obj.h"
#include "scene_steps.h"

struct etch_scene_mesh {
    struct etch_obj obj;
    struct etch_lighting lighting;
    struct etch_light light[ETCH_SCENE_LIGHTS];
    struct etch_mesh_texture_stage stage; /* whose coordinates a mesh with a texture has */
    struct etch_texture texture;
    struct etch_assembly assembly;
    struct etch_mesh_vertex *vertex;           /* transformed: this .. */
    struct etch_mesh_texture_vertex *textured; /* .. or, with a texture, this */
};

/* Model units of the mesh to those of the file, which differ by 2^(bits - scale). */
static bool add_file_units(struct etch_scene_reader *reader, const struct etch_obj *obj)
{
    const int shift = obj->mesh.bits - obj->scale;
    struct etch_matrix m;
    etch_q16 factor;

    if (shift > 14 || shift < -16) {
        return etch_text_fail(&reader->text, "the coordinates of the mesh are too %s",
                              shift > 0 ? "large" : "small");
    }
    factor = shift >= 0 ? ETCH_Q16_ONE << shift : ETCH_Q16_ONE >> -shift;
    etch_matrix_scale(&m, factor, factor, factor);
    return etch_matrix_multiply(&reader->view.model, &reader->view.model, &m) == ETCH_OK ||
           etch_text_fail(&reader->text, "the model's matrix leaves 16.16");
}

static bool aim_lights(struct etch_scene_reader *reader, struct etch_scene_mesh *mesh)
{
    const struct etch_scene_view *view = &reader->view;

    for (int i = 0; i < 3; i++) {
        mesh->lighting.ambient[i] = view->ambient[i];
    }
    mesh->lighting.count = view->light_count;
    mesh->lighting.light = mesh->light;
    for (int i = 0; i < view->light_count; i++) {
        if (etch_light_aim(&mesh->light[i], &view->model, &view->light_towards[i]) != ETCH_OK) {
            return etch_text_fail(&reader->text, "light %d cannot be brought to the model", i + 1);
        }
        for (int k = 0; k < 3; k++) {
            mesh->light[i].diffuse[k] = view->light_color[i][k];
        }
    }
    return true;
}

/* The vertices, without a texture or with one. */
static bool transform(struct etch_scene_reader *reader, struct etch_scene_mesh *mesh, bool textured)
{
    const struct etch_viewport *viewport = &mesh->assembly.viewport;
    const size_t count = mesh->obj.mesh.vertex_count;
    struct etch_mesh_texture_stage *stage = &mesh->stage;

    if (textured && mesh->obj.coordinates == NULL) {
        return etch_text_fail(&reader->text,
                              "\"state tex\" needs a mesh with a vt at every corner");
    }
    if (!textured) {
        mesh->vertex = calloc(count, sizeof *mesh->vertex);
    } else {
        mesh->textured = calloc(count, sizeof *mesh->textured);
    }
    if (mesh->vertex == NULL && mesh->textured == NULL) {
        return etch_text_fail(&reader->text, "out of memory");
    }
    if (!textured) {
        etch_mesh_transform(&stage->stage, viewport, mesh->vertex);
        reader->scene->vertex_bytes += count * sizeof *mesh->vertex;
        return true;
    }
    stage->inner = stage->stage.vertex;
    stage->stage.vertex = etch_vertex_textured;
    stage->coordinates = mesh->obj.coordinates;
    stage->scale_u = (etch_q16)1 << (mesh->texture.width_bits + 16 - mesh->obj.coordinate_bits);
    stage->scale_v = (etch_q16)1 << (mesh->texture.height_bits + 16 - mesh->obj.coordinate_bits);
    etch_mesh_transform_varying(&stage->stage, viewport, mesh->textured, 2);
    reader->scene->vertex_bytes += count * sizeof *mesh->textured;
    return true;
}

/* Everything that does not depend on the strip: matrices, light, the vertices themselves. */
static bool prepare(struct etch_scene_reader *reader, struct etch_scene_mesh *mesh, bool textured)
{
    const struct etch_rect frame = {0, 0, reader->scene->width, reader->scene->height};
    const struct etch_matrix model = reader->view.model;
    struct etch_matrix m;
    const bool ok = add_file_units(reader, &mesh->obj) && aim_lights(reader, mesh) &&
                    etch_scene_model_to_clip(reader, &m);

    reader->view.model = model;
    if (!ok) {
        return false;
    }
    etch_mesh_stage_init(&mesh->stage.stage, &mesh->obj.mesh, &m, etch_vertex_lit, &mesh->lighting);
    for (int i = 0; i < 4; i++) {
        mesh->stage.stage.color[i] = reader->view.material[i];
    }
    mesh->assembly.cull = etch_scene_cull(&reader->state);
    mesh->assembly.flat = reader->state.shade != 0;
    (void)etch_viewport_init(&mesh->assembly.viewport, frame);
    return transform(reader, mesh, textured);
}

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

/* The sink of a mesh with a texture. */
struct texture_sink {
    struct etch_sink sink; /* first */
    struct etch_scene_run *run;
    const struct etch_scene_step *step;
};

static void paint_texture(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    const struct texture_sink *s = (const void *)sink;
    const struct etch_texture_vertex *const textured[3] = {(const void *)v[0], (const void *)v[1],
                                                           (const void *)v[2]};

    if (s->run->stats != NULL) {
        s->run->stats->triangles++;
    }
    etch_scene_paint_texture(s->run, s->step->pipeline, textured, &s->step->of.mesh->texture);
}

static void draw_textured(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct etch_scene_mesh *mesh = step->of.mesh;
    struct etch_assembly assembly = mesh->assembly;
    struct texture_sink sink = {{.triangle = paint_texture}, run, step};

    assembly.sink = &sink.sink;
    etch_mesh_assemble_varying(&mesh->stage.stage, &assembly, mesh->textured, 2);
}

static const struct etch_scene_statement textured_mesh = {
    "mesh", NULL, draw_textured,
    "etch_mesh_transform_varying etch_mesh_assemble_varying etch_vertex_textured etch_vertex_lit",
    NULL};

static void draw_mesh(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct etch_scene_mesh *mesh = step->of.mesh;
    struct etch_assembly assembly = mesh->assembly;
    struct etch_scene_sink sink;

    etch_scene_sink_init(&sink, run, step->pipeline);
    assembly.sink = run->collect != NULL ? run->collect : &sink.raster.sink;
    etch_mesh_assemble(&mesh->stage.stage, &assembly, mesh->vertex);
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
    if (path == NULL) {
        return false;
    }
    step->pipeline = etch_scene_read_pipeline(reader);
    if (step->pipeline == NULL) {
        return false;
    }
    if (step->pipeline->texture != NULL) {
        step->statement = &textured_mesh;
        if (!etch_scene_take_texture(reader, &mesh->texture)) {
            return false;
        }
    }
    return etch_text_open_named(&text, path, name, &reader->text) &&
           etch_obj_read(&mesh->obj, &text) &&
           prepare(reader, mesh, step->pipeline->texture != NULL);
}

void etch_scene_mesh_free(struct etch_scene_mesh *mesh)
{
    etch_obj_close(&mesh->obj);
    free(mesh->vertex);
    free(mesh->textured);
    free(mesh);
}

const struct etch_scene_statement etch_scene_mesh_statements[] = {
    {"mesh", read_mesh, draw_mesh, "etch_mesh_transform etch_mesh_assemble etch_vertex_lit", NULL},
    {NULL, NULL, NULL, NULL, NULL},
};
