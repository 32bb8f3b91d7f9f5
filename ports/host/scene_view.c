/* ports/host/scene_view.c: the statements that say how the next mesh is seen. scene.c
 * finds them by name, scene_mesh.c reads what they set. */
#include "scene_steps.h"

static bool read_vector(struct etch_scene_reader *reader, struct etch_vector *v)
{
    return etch_text_q16(&reader->text, "x", &v->x) && etch_text_q16(&reader->text, "y", &v->y) &&
           etch_text_q16(&reader->text, "z", &v->z);
}

/* eye, target [, up] */
static bool read_camera(struct etch_scene_reader *reader,
                        const struct etch_scene_statement *statement)
{
    struct etch_scene_view *view = &reader->view;

    (void)statement;
    view->up = (struct etch_vector){0, ETCH_Q16_ONE, 0};
    return read_vector(reader, &view->eye) && read_vector(reader, &view->target) &&
           (!etch_text_more(&reader->text) || read_vector(reader, &view->up));
}

static bool read_range(struct etch_scene_reader *reader)
{
    return etch_text_q16(&reader->text, "near", &reader->view.near) &&
           etch_text_q16(&reader->text, "far", &reader->view.far);
}

static bool read_perspective(struct etch_scene_reader *reader,
                             const struct etch_scene_statement *statement)
{
    (void)statement;
    reader->view.parallel = reader->view.canonical = reader->view.frustum = false;
    if (!etch_text_q16(&reader->text, "degrees", &reader->view.angle_of_view) ||
        !read_range(reader)) {
        return false;
    }
    reader->scene->near = reader->view.near;
    reader->scene->far = reader->view.far;
    return true;
}

/* the sides of what is seen on the near plane, the eye anywhere before it */
static bool read_frustum(struct etch_scene_reader *reader,
                         const struct etch_scene_statement *statement)
{
    struct etch_box *box = &reader->view.box;

    (void)statement;
    reader->view.parallel = reader->view.canonical = false;
    reader->view.frustum = true;
    return etch_text_q16(&reader->text, "left", &box->left) &&
           etch_text_q16(&reader->text, "right", &box->right) &&
           etch_text_q16(&reader->text, "bottom", &box->bottom) &&
           etch_text_q16(&reader->text, "top", &box->top) &&
           etch_text_q16(&reader->text, "near", &box->near) &&
           etch_text_q16(&reader->text, "far", &box->far);
}

static bool read_parallel(struct etch_scene_reader *reader,
                          const struct etch_scene_statement *statement)
{
    (void)statement;
    reader->view.parallel = true;
    reader->view.canonical = false;
    return etch_text_q16(&reader->text, "height", &reader->view.height) && read_range(reader);
}

/* what stands in -1 .. 1 in x, y and z is seen as it is */
static bool read_canonical(struct etch_scene_reader *reader,
                           const struct etch_scene_statement *statement)
{
    (void)statement;
    reader->view.canonical = true;
    return true;
}

/* ---- the model's place ------------------------------------------------------------------- */

/* Degrees in 16.16 to 65536ths of a turn, to the nearest. */
static uint16_t angle_from_degrees(etch_q16 degrees)
{
    const int32_t turn = 360 * ETCH_Q16_ONE;
    const int32_t within = degrees % turn + (degrees < 0 ? turn : 0); /* 0 .. turn */

    return (uint16_t)((uint32_t)(within + 180) / 360 & 0xFFFF);
}

static bool read_rotate(struct etch_scene_reader *reader, struct etch_matrix *m)
{
    static const char *const axes[] = {"x", "y", "z", NULL};
    static void (*const rotate[])(struct etch_matrix *, uint16_t) = {
        etch_matrix_rotate_x, etch_matrix_rotate_y, etch_matrix_rotate_z};
    etch_q16 degrees;
    int axis;

    if (!etch_text_choice(&reader->text, "axis", axes, &axis) ||
        !etch_text_q16(&reader->text, "degrees", &degrees)) {
        return false;
    }
    rotate[axis](m, angle_from_degrees(degrees));
    return true;
}

static bool read_translate(struct etch_scene_reader *reader, struct etch_matrix *m)
{
    struct etch_vector v;

    if (!read_vector(reader, &v)) {
        return false;
    }
    etch_matrix_translate(m, v.x, v.y, v.z);
    return true;
}

/* one factor, or one for each axis */
static bool read_scale(struct etch_scene_reader *reader, struct etch_matrix *m)
{
    struct etch_vector v;

    if (!etch_text_q16(&reader->text, "x", &v.x)) {
        return false;
    }
    v.y = v.z = v.x;
    if (etch_text_more(&reader->text) &&
        (!etch_text_q16(&reader->text, "y", &v.y) || !etch_text_q16(&reader->text, "z", &v.z))) {
        return false;
    }
    etch_matrix_scale(m, v.x, v.y, v.z);
    return true;
}

/* sixteen numbers, row by row */
static bool read_matrix(struct etch_scene_reader *reader, struct etch_matrix *m)
{
    for (int i = 0; i < 16; i++) {
        if (!etch_text_q16(&reader->text, "entry", &m->m[i / 4][i % 4])) {
            return false;
        }
    }
    return true;
}

/* identity | translate .. | rotate .. | scale .. | matrix .. | shadow ..: applied after those
 * before it */
static bool read_model(struct etch_scene_reader *reader,
                       const struct etch_scene_statement *statement)
{
    static const char *const words[] = {"identity", "translate", "rotate", "scale",
                                        "matrix",   "shadow",    NULL};
    static bool (*const read[])(struct etch_scene_reader *, struct etch_matrix *) = {
        NULL, read_translate, read_rotate, read_scale, read_matrix, etch_scene_read_shadow};
    struct etch_matrix *model = &reader->view.model;
    struct etch_matrix m;
    int index;

    (void)statement;
    if (!etch_text_choice(&reader->text, "model", words, &index)) {
        return false;
    }
    if (index == 0) {
        etch_matrix_identity(model);
        return true;
    }
    if (!read[index](reader, &m)) {
        return false;
    }
    return etch_matrix_multiply(model, &m, model) == ETCH_OK ||
           etch_text_fail(&reader->text, "the model's matrix leaves 16.16");
}

/* ---- all together ------------------------------------------------------------------------- */

static enum etch_status make_projection(const struct etch_scene_reader *reader,
                                        struct etch_matrix *m)
{
    const struct etch_scene_view *view = &reader->view;
    const etch_q16 aspect = etch_q16_div(reader->scene->width * ETCH_Q16_ONE,
                                         reader->scene->height * ETCH_Q16_ONE);
    const etch_q16 up = view->height / 2;
    const etch_q16 right = etch_q16_mul(up, aspect);
    const struct etch_box box = {-right, right, -up, up, view->near, view->far};

    if (view->parallel) {
        return etch_matrix_orthographic(m, &box);
    }
    if (view->frustum) {
        return etch_matrix_frustum(m, &view->box);
    }
    if (view->angle_of_view <= 0 || view->angle_of_view >= 180 * ETCH_Q16_ONE) {
        return ETCH_EINVAL;
    }
    return etch_matrix_perspective(m, angle_from_degrees(view->angle_of_view), aspect, view->near,
                                   view->far);
}

bool etch_scene_model_to_clip(struct etch_scene_reader *reader, struct etch_matrix *m)
{
    const struct etch_scene_view *view = &reader->view;
    struct etch_matrix eye;

    if (view->canonical) {
        *m = view->model;
        return true;
    }
    if (make_projection(reader, m) != ETCH_OK) {
        return etch_text_fail(&reader->text,
                              "there is no such perspective, frustum or parallel view");
    }
    if (etch_matrix_look_at(&eye, &view->eye, &view->target, &view->up) != ETCH_OK) {
        return etch_text_fail(&reader->text, "the camera has no direction or is too far away");
    }
    if (etch_matrix_multiply(&eye, &eye, &view->model) != ETCH_OK ||
        etch_matrix_multiply(m, m, &eye) != ETCH_OK) {
        return etch_text_fail(&reader->text, "model and camera together leave 16.16");
    }
    return true;
}

const struct etch_scene_statement etch_scene_view_statements[] = {
    {"camera", read_camera, NULL, NULL, NULL},
    {"perspective", read_perspective, NULL, NULL, NULL},
    {"frustum", read_frustum, NULL, NULL, NULL},
    {"parallel", read_parallel, NULL, NULL, NULL},
    {"canonical", read_canonical, NULL, NULL, NULL},
    {"model", read_model, NULL, NULL, NULL},
    {NULL, NULL, NULL, NULL, NULL},
};
