/* ports/host/scene_mesh_stage.c: a mesh's matrices, lights and vertices. scene_mesh.c calls it once
 * a mesh, and to hand the triangles on. */
#include <stdlib.h>

#include "scene_mesh.h"
#include "scene_primitive.h"

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

/* ---- light ----------------------------------------------------------------------------------- */

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

/* Where the eye is; in parallel views, which way. */
static void set_eye(struct etch_lamps *lamps, const struct etch_scene_view *view)
{
    const struct etch_vector *e = &view->eye, *t = &view->target;
    const int32_t back[3] = {(e->x >> 1) - (t->x >> 1), (e->y >> 1) - (t->y >> 1),
                             (e->z >> 1) - (t->z >> 1)};
    int16_t unit[3] = {0, 0, 16384};

    lamps->eye_is_far = view->parallel || view->canonical;
    lamps->eye = view->eye;
    if (lamps->eye_is_far) {
        if (!view->canonical) {
            (void)etch_unit_q14(unit, back);
        }
        lamps->eye = (struct etch_vector){unit[0], unit[1], unit[2]};
    }
}

static void set_lamps(struct etch_scene_mesh *mesh, const struct etch_scene_view *view)
{
    mesh->material = view->surface;
    mesh->lamps.material = &mesh->material;
    mesh->lamps.lamp = mesh->lamp;
    mesh->lamps.count = view->light_count;
    for (int i = 0; i < ETCH_SCENE_LIGHTS; i++) {
        mesh->lamp[i] = view->lamp[i];
    }
    for (int k = 0; k < 3; k++) {
        mesh->lamps.ambient[k] = view->ambient[k];
    }
    set_eye(&mesh->lamps, view);
}

/* Without specular light there is no eye to look for. */
static etch_shade_function *shade_of(const struct etch_scene_view *view)
{
    const uint8_t *s = view->surface.specular;

    return (s[0] | s[1] | s[2]) == 0 ? etch_shade_diffuse
           : view->blinn             ? etch_shade_blinn
                                     : etch_shade_phong;
}

bool etch_scene_mesh_has_lamps(const struct etch_scene_view *view)
{
    const struct etch_material *surface = &view->surface;
    bool plain = true;

    for (int k = 0; k < 3; k++) {
        plain &= surface->ambient[k] == 255 && surface->emission[k] == 0;
    }
    return view->lamps && (view->light_count != 0 || !plain);
}

/* Sets mesh->stage.lit: the cheap light where it will do. */
static bool set_light(struct etch_scene_reader *reader, struct etch_scene_mesh *mesh,
                      const struct etch_matrix *m)
{
    struct etch_mesh_shaded_stage *lit = &mesh->stage.lit;
    const struct etch_scene_view *view = &reader->view;

    if (!etch_scene_mesh_has_lamps(view) && reader->state.shade != 2) {
        if (!aim_lights(reader, mesh)) {
            return false;
        }
        etch_mesh_stage_init(&lit->stage, &mesh->obj.mesh, m, etch_vertex_lit, &mesh->lighting);
        return true;
    }
    set_lamps(mesh, view);
    if (etch_mesh_shaded_init(lit, &mesh->obj.mesh, m, &view->model, shade_of(view),
                              &mesh->lamps) != ETCH_OK) {
        return etch_text_fail(&reader->text, "the model leaves no normals");
    }
    mesh->phong = (struct etch_phong){lit->shade, &mesh->lamps};
    if (reader->state.shade == 2) {
        lit->stage.vertex = etch_vertex_normal;
    }
    return true;
}

/* ---- vertices -------------------------------------------------------------------------------- */

/* What etch_vertex_textured runs first: the lit stage is the second in the same struct. */
static void inner(const struct etch_mesh_stage *stage, uint16_t index, struct etch_clip_vertex *out)
{
    const struct etch_scene_mesh_stage *both = (const void *)stage;

    both->lit.stage.vertex(&both->lit.stage, index, out);
}

static bool set_texture(struct etch_scene_reader *reader, struct etch_scene_mesh *mesh)
{
    struct etch_mesh_texture_stage *textured = &mesh->stage.textured;
    const uint8_t bits = mesh->obj.coordinate_bits;

    if (mesh->obj.coordinates == NULL) {
        return etch_text_fail(&reader->text,
                              "\"state tex\" needs a mesh with a vt at every corner");
    }
    textured->stage = mesh->stage.lit.stage;
    textured->stage.vertex = etch_vertex_textured;
    textured->inner = inner;
    textured->coordinates = mesh->obj.coordinates;
    textured->scale_u = etch_saturate_s32(reader->texture->image.width * INT64_C(65536) >> bits);
    textured->scale_v = etch_saturate_s32(reader->texture->image.height * INT64_C(65536) >> bits);
    mesh->drawn = &textured->stage;
    return true;
}

static bool transform(struct etch_scene_reader *reader, struct etch_scene_mesh *mesh)
{
    const size_t size = mesh->varyings == 0   ? sizeof(struct etch_mesh_vertex)
                        : mesh->varyings == 2 ? sizeof(struct etch_mesh_texture_vertex)
                                              : sizeof(struct etch_mesh_shade_vertex);
    const size_t bytes = size * mesh->obj.mesh.vertex_count;

    mesh->buffer = malloc(bytes);
    if (mesh->buffer == NULL) {
        return etch_text_fail(&reader->text, "out of memory");
    }
    reader->scene->vertex_bytes += bytes;
    if (mesh->varyings == 0) {
        etch_mesh_transform(mesh->drawn, &mesh->assembly.viewport, mesh->buffer);
    } else {
        etch_mesh_transform_varying(mesh->drawn, &mesh->assembly.viewport, mesh->buffer,
                                    mesh->varyings);
    }
    return true;
}

bool etch_scene_mesh_prepare(struct etch_scene_reader *reader, struct etch_scene_mesh *mesh)
{
    const struct etch_rect frame = {0, 0, reader->scene->width, reader->scene->height};
    const struct etch_matrix model = reader->view.model;
    struct etch_matrix m;
    const bool ok = add_file_units(reader, &mesh->obj) && etch_scene_model_to_clip(reader, &m) &&
                    set_light(reader, mesh, &m);

    reader->view.model = model;
    if (!ok) {
        return false;
    }
    for (int i = 0; i < 4; i++) {
        mesh->stage.lit.stage.color[i] = reader->view.material[i];
    }
    mesh->assembly.cull = etch_scene_cull(&reader->state);
    mesh->assembly.flat = reader->state.shade == 1;
    (void)etch_viewport_init(&mesh->assembly.viewport, frame);
    mesh->drawn = &mesh->stage.lit.stage;
    mesh->varyings = reader->state.shade == 2 ? 8 : reader->state.tex != 0 ? 2 : 0;
    return (reader->state.tex == 0 || set_texture(reader, mesh)) &&
           (mesh->primitive.kind != 0 || transform(reader, mesh));
}

void etch_scene_mesh_assemble(const struct etch_scene_mesh *mesh, struct etch_sink *sink)
{
    struct etch_assembly assembly = mesh->assembly;

    assembly.sink = sink;
    if (mesh->primitive.kind != 0) {
        struct etch_scene_primitive primitive;

        etch_scene_primitive_init(&primitive, &mesh->primitive, mesh->drawn, &assembly);
        etch_mesh_primitive_triangles(&primitive.primitive);
    } else if (mesh->varyings == 0) {
        etch_mesh_assemble(mesh->drawn, &assembly, mesh->buffer);
    } else {
        etch_mesh_assemble_varying(mesh->drawn, &assembly, mesh->buffer, mesh->varyings);
    }
}
