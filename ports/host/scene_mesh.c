/* ports/host/scene_mesh.c: the mesh statement. scene.c finds it by name. A mesh is transformed
 * and lit when it is read, and only rasterised when it is drawn: once for every strip. */
#include <stdlib.h>

#include "array.h"
#include "obj.h"
#include "scene_steps.h"

struct etch_scene_mesh {
    struct etch_obj obj;
    struct etch_lighting lighting;
    struct etch_light light[ETCH_SCENE_LIGHTS];
    struct etch_mesh_stage stage;
    struct etch_assembly assembly;
    struct etch_mesh_vertex *vertex; /* transformed */
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

/* Everything that does not depend on the strip: matrices, light, the vertices themselves. */
static bool prepare(struct etch_scene_reader *reader, struct etch_scene_mesh *mesh)
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
    mesh->vertex = calloc(mesh->obj.mesh.vertex_count, sizeof *mesh->vertex);
    if (mesh->vertex == NULL) {
        return etch_text_fail(&reader->text, "out of memory");
    }
    etch_mesh_stage_init(&mesh->stage, &mesh->obj.mesh, &m, etch_vertex_lit, &mesh->lighting);
    for (int i = 0; i < 4; i++) {
        mesh->stage.color[i] = reader->view.material[i];
    }
    mesh->assembly.cull = etch_scene_cull(&reader->state);
    mesh->assembly.flat = reader->state.shade != 0;
    (void)etch_viewport_init(&mesh->assembly.viewport, frame);
    etch_mesh_transform(&mesh->stage, &mesh->assembly.viewport, mesh->vertex);
    reader->scene->vertex_bytes += mesh->obj.mesh.vertex_count * sizeof *mesh->vertex;
    return true;
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

static void draw_mesh(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    const struct etch_scene_mesh *mesh = step->of.mesh;
    struct etch_assembly assembly = mesh->assembly;
    struct etch_scene_sink sink;

    etch_scene_sink_init(&sink, run, step->pipeline);
    assembly.sink = &sink.raster.sink;
    etch_mesh_assemble(&mesh->stage, &assembly, mesh->vertex);
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
        return etch_text_fail(&reader->text, "drawing a mesh with this \"state tex\" is not "
                                             "supported yet");
    }
    return etch_text_open_named(&text, path, name, &reader->text) &&
           etch_obj_read(&mesh->obj, &text) && prepare(reader, mesh);
}

void etch_scene_mesh_free(struct etch_scene_mesh *mesh)
{
    etch_obj_close(&mesh->obj);
    free(mesh->vertex);
    free(mesh);
}

const struct etch_scene_statement etch_scene_mesh_statements[] = {
    {"mesh", read_mesh, draw_mesh, "etch_mesh_transform etch_mesh_assemble etch_vertex_lit", NULL},
    {NULL, NULL, NULL, NULL, NULL},
};
