/* ports/host/scene_elements.c: primitives from lists of vertices: list, vertex, index, endlist.
 * scene.c finds them by name. Vertices are transformed by a vertex function of the simulator's own,
 * when the list ends; primitives are assembled when they are drawn (scene_elements_draw.c). */
#include "scene_elements.h"

#include "scene_lines.h"
#include "scene_primitive.h"

/* The vertex function: positions in 16.16. */
static void transform(const struct etch_mesh_stage *stage, uint16_t index,
                      struct etch_clip_vertex *out)
{
    const struct elements *e = (const void *)stage;
    const struct etch_scene_element_vertex *v = &e->vertex[index];
    etch_q16 clip[4];

    for (int i = 0; i < 4; i++) { /* below 3 * 2^46 + 2^31 */
        const etch_q16 *row = e->matrix.m[i];
        int64_t sum = row[3];

        for (int k = 0; k < 3; k++) {
            sum += (etch_mul_s32(row[k], v->p[k]) + 32768) >> 16;
        }
        clip[i] = etch_saturate_s32(sum);
    }
    *out = (struct etch_clip_vertex){clip[0],    clip[1],    clip[2],    clip[3],
                                     v->rgba[0], v->rgba[1], v->rgba[2], v->rgba[3]};
}

/* The size of points in pixels, 1 if it is not given. */
static bool read_size(struct etch_scene_reader *reader, struct elements *e)
{
    etch_q16 size = ETCH_Q16_ONE;

    if (etch_text_more(&reader->text) && !etch_text_q16(&reader->text, "size", &size)) {
        return false;
    }
    e->size_q8 = (uint16_t)(size > 0 && size < 256 * ETCH_Q16_ONE ? etch_snap_q8(size) : 0);
    return e->size_q8 != 0 || etch_text_fail(&reader->text, "size must be above 0 and below 256");
}

static bool read_pipeline(struct etch_scene_reader *reader, struct etch_scene_step *step,
                          const struct elements *e, bool triangles)
{
    if (reader->primitive.kind != 0 && !triangles) {
        return etch_text_fail(&reader->text, "\"primitive\" is for triangles");
    }
    if (!triangles || reader->primitive.kind == ETCH_SCENE_WIREFRAME) {
        return etch_scene_lines_pipeline(
            reader, step, e->kind == etch_elements_points ? ETCH_SCENE_POINT : ETCH_SCENE_LINE);
    }
    if (reader->state.tex != 0) {
        return etch_text_fail(&reader->text, "\"state tex\" is on, but vertices of lists have no "
                                             "texture coordinates");
    }
    step->pipeline = etch_scene_read_pipeline(reader);
    return step->pipeline != NULL;
}

/* kind [size] */
static bool read_list(struct etch_scene_reader *reader,
                      const struct etch_scene_statement *statement)
{
    static const char *const words[] = {"points",    "lines",         "linestrip",   "lineloop",
                                        "triangles", "trianglestrip", "trianglefan", NULL};
    const struct etch_rect frame = {0, 0, reader->scene->width, reader->scene->height};
    struct etch_scene_step *step;
    struct elements *e;
    int kind;

    if (reader->elements != NULL) {
        return etch_text_fail(&reader->text, "\"list\" within \"list\"");
    }
    if (!etch_text_choice(&reader->text, "kind", words, &kind)) {
        return false;
    }
    step = etch_scene_append(reader, statement);
    e = step != NULL ? etch_scene_data(reader, sizeof *e) : NULL;
    if (e == NULL || (kind == 0 && !read_size(reader, e))) {
        return false;
    }
    step->of.data = e;
    e->primitive = reader->primitive;
    step->statement = e->primitive.kind != 0
                          ? &etch_scene_element_kinds[kind].by_primitive[e->primitive.kind - 1]
                          : &etch_scene_element_kinds[kind].statement;
    e->kind = etch_scene_element_kinds[kind].kind;
    e->taker = etch_scene_element_kinds[kind].taker;
    e->stage.mesh = &e->mesh;
    e->stage.vertex = transform;
    e->assembly.cull = etch_scene_cull(&reader->state);
    e->assembly.flat = reader->state.shade == 1;
    (void)etch_viewport_init(&e->assembly.viewport, frame);
    reader->elements = e;
    return read_pipeline(reader, step, e, kind >= 4) &&
           etch_scene_model_to_clip(reader, &e->matrix);
}

static struct elements *current(struct etch_scene_reader *reader)
{
    if (reader->elements == NULL) {
        (void)etch_text_fail(&reader->text, "this stands in a \"list\"");
    }
    return reader->elements;
}

/* x y z r g b [a] */
static bool read_vertex(struct etch_scene_reader *reader,
                        const struct etch_scene_statement *statement)
{
    struct elements *e = current(reader);
    struct etch_scene_element_vertex *v;

    (void)statement;
    if (e == NULL) {
        return false;
    }
    if (e->mesh.vertex_count == ETCH_SCENE_VERTICES) {
        return etch_text_fail(&reader->text, "more than %d vertices", ETCH_SCENE_VERTICES);
    }
    v = &e->vertex[e->mesh.vertex_count++];
    v->rgba[3] = 255;
    return etch_text_q16(&reader->text, "x", &v->p[0]) &&
           etch_text_q16(&reader->text, "y", &v->p[1]) &&
           etch_text_q16(&reader->text, "z", &v->p[2]) && etch_scene_read_rgb(reader, v->rgba) &&
           (!etch_text_more(&reader->text) || etch_scene_read_byte(reader, "a", &v->rgba[3]));
}

/* any number of them; -1 begins anew */
static bool read_index(struct etch_scene_reader *reader,
                       const struct etch_scene_statement *statement)
{
    struct elements *e = current(reader);
    int64_t index;

    (void)statement;
    while (e != NULL) {
        if (e->index_count == ETCH_SCENE_INDICES) {
            return etch_text_fail(&reader->text, "more than %d indices", ETCH_SCENE_INDICES);
        }
        if (!etch_text_integer(&reader->text, "index", -1, ETCH_SCENE_VERTICES - 1, &index)) {
            return false;
        }
        e->index[e->index_count++] = (uint16_t)(index < 0 ? UINT16_MAX : index);
        if (!etch_text_more(&reader->text)) {
            return true;
        }
    }
    return false;
}

static bool read_end(struct etch_scene_reader *reader, const struct etch_scene_statement *statement)
{
    struct elements *e = current(reader);

    (void)statement;
    if (e == NULL) {
        return false;
    }
    etch_mesh_transform(&e->stage, &e->assembly.viewport, e->buffer);
    reader->scene->vertex_bytes += e->mesh.vertex_count * sizeof e->buffer[0];
    reader->elements = NULL;
    return true;
}

const struct etch_scene_statement etch_scene_elements_statements[] = {
    {"list", read_list, NULL, NULL, NULL},
    {"vertex", read_vertex, NULL, NULL, NULL},
    {"index", read_index, NULL, NULL, NULL},
    {"endlist", read_end, NULL, NULL, NULL},
    {"primitive", etch_scene_read_primitive, NULL, NULL, NULL},
    {NULL, NULL, NULL, NULL, NULL},
};
