/* ports/host/scene_elements.c: primitives from lists of vertices: list, vertex, index, endlist. scene.c
 * finds them by name. Vertices are transformed by a vertex function of the simulator's own, when the
 * list ends; primitives are assembled when they are drawn, once for every strip. */
#include "scene_elements.h"

#include <string.h>

#include "../../core/draw/mesh_elements.h"
#include "scene_lines.h"
#include "scene_primitive.h"

enum {
    MOST_VERTICES = 256,
    MOST_INDICES = 1024,
    MOST_KINDS = 7
};

struct vertex {
    etch_q16 p[3];
    uint8_t rgba[4];
};

struct elements {
    struct etch_mesh_stage stage; /* first: the vertex function finds the rest behind it */
    struct etch_mesh mesh;
    struct etch_matrix matrix;
    struct etch_assembly assembly;
    etch_element_kind *kind;
    etch_element_taker *taker;
    struct etch_scene_primitive_choice primitive; /* of triangles */
    uint16_t size_q8;                             /* of points */
    uint32_t index_count;
    uint16_t index[MOST_INDICES];
    struct vertex vertex[MOST_VERTICES];
    struct etch_mesh_vertex buffer[MOST_VERTICES];
};

static etch_scene_draw_function draw_points, draw_lines, draw_triangles;

#define PRIMITIVE "etch_mesh_primitive_init "
#define LINES "etch_mesh_transform etch_mesh_take_line "
#define TRIANGLES "etch_mesh_transform etch_mesh_take_triangle "
static const struct kind {
    etch_element_kind *kind;
    etch_element_taker *taker;
    struct etch_scene_statement statement; /* of the step; below with shrink, wireframe */
    struct etch_scene_statement by_primitive[2];
} kinds[MOST_KINDS] = {
    {etch_elements_points,
     etch_mesh_take_point,
     {"list", NULL, draw_points, "etch_mesh_transform etch_mesh_take_point etch_elements_points",
      NULL},
     {{NULL, NULL, NULL, NULL, NULL}, {NULL, NULL, NULL, NULL, NULL}}},
    {etch_elements_lines,
     etch_mesh_take_line,
     {"list", NULL, draw_lines, LINES "etch_elements_lines", NULL},
     {{NULL, NULL, NULL, NULL, NULL}, {NULL, NULL, NULL, NULL, NULL}}},
    {etch_elements_line_strip,
     etch_mesh_take_line,
     {"list", NULL, draw_lines, LINES "etch_elements_line_strip", NULL},
     {{NULL, NULL, NULL, NULL, NULL}, {NULL, NULL, NULL, NULL, NULL}}},
    {etch_elements_line_loop,
     etch_mesh_take_line,
     {"list", NULL, draw_lines, LINES "etch_elements_line_loop", NULL},
     {{NULL, NULL, NULL, NULL, NULL}, {NULL, NULL, NULL, NULL, NULL}}},
    {etch_elements_triangles,
     etch_mesh_take_triangle,
     {"list", NULL, draw_triangles, TRIANGLES "etch_elements_triangles", NULL},
     {{"list", NULL, draw_triangles, PRIMITIVE "etch_assemble_triangle etch_elements_triangles",
       NULL},
      {"list", NULL, draw_lines, PRIMITIVE "etch_assemble_line etch_elements_triangles", NULL}}},
    {etch_elements_triangle_strip,
     etch_mesh_take_triangle,
     {"list", NULL, draw_triangles, TRIANGLES "etch_elements_triangle_strip", NULL},
     {{"list", NULL, draw_triangles,
       PRIMITIVE "etch_assemble_triangle etch_elements_triangle_strip", NULL},
      {"list", NULL, draw_lines, PRIMITIVE "etch_assemble_line etch_elements_triangle_strip",
       NULL}}},
    {etch_elements_triangle_fan,
     etch_mesh_take_triangle,
     {"list", NULL, draw_triangles, TRIANGLES "etch_elements_triangle_fan", NULL},
     {{"list", NULL, draw_triangles, PRIMITIVE "etch_assemble_triangle etch_elements_triangle_fan",
       NULL},
      {"list", NULL, draw_lines, PRIMITIVE "etch_assemble_line etch_elements_triangle_fan", NULL}}},
};

/* ---- reading --------------------------------------------------------------------------------- */

/* The vertex function: positions in 16.16. */
static void transform(const struct etch_mesh_stage *stage, uint16_t index,
                      struct etch_clip_vertex *out)
{
    const struct elements *e = (const void *)stage;
    const struct vertex *v = &e->vertex[index];
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
    step->statement = e->primitive.kind != 0 ? &kinds[kind].by_primitive[e->primitive.kind - 1]
                                             : &kinds[kind].statement;
    e->kind = kinds[kind].kind;
    e->taker = kinds[kind].taker;
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
    struct vertex *v;

    (void)statement;
    if (e == NULL) {
        return false;
    }
    if (e->mesh.vertex_count == MOST_VERTICES) {
        return etch_text_fail(&reader->text, "more than %d vertices", MOST_VERTICES);
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
        if (e->index_count == MOST_INDICES) {
            return etch_text_fail(&reader->text, "more than %d indices", MOST_INDICES);
        }
        if (!etch_text_integer(&reader->text, "index", -1, MOST_VERTICES - 1, &index)) {
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

/* ---- drawing --------------------------------------------------------------------------------- */

void etch_scene_elements_assemble(const struct etch_scene_step *step, struct etch_sink *sink)
{
    const struct elements *e = step->of.data;
    const bool indexed = e->index_count != 0;
    const struct etch_elements list = {indexed ? e->index : NULL,
                                       indexed ? e->index_count : e->mesh.vertex_count,
                                       e->mesh.vertex_count};
    struct etch_assembly assembly = e->assembly;
    struct etch_mesh_elements to;

    assembly.sink = sink;
    if (e->primitive.kind != 0) {
        struct etch_scene_primitive primitive;

        etch_scene_primitive_init(&primitive, &e->primitive, &e->stage, &assembly);
        e->kind(&list, &primitive.primitive.sink);
        return;
    }
    etch_mesh_elements_init(&to, e->taker, &e->stage, &assembly, e->buffer);
    e->kind(&list, &to.sink);
}

struct sink {
    struct etch_sink sink; /* first */
    struct etch_scene_run *run;
    const struct etch_scene_step *step;
};

static void paint_point(struct etch_sink *sink, const struct etch_vertex *v)
{
    const struct sink *s = (const void *)sink;
    const struct elements *e = s->step->of.data;

    etch_scene_paint_point(s->run, s->step, v, e->size_q8, etch_point_runs_round);
}

static void draw_points(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    struct sink sink = {{.point = paint_point}, run, step};

    etch_scene_elements_assemble(step, &sink.sink);
}

static void draw_lines(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    struct etch_scene_line_sink sink;

    etch_scene_line_sink_init(&sink, run, step);
    etch_scene_elements_assemble(step, &sink.sink);
}

static void draw_triangles(struct etch_scene_run *run, const struct etch_scene_step *step)
{
    struct etch_scene_sink sink;

    etch_scene_sink_init(&sink, run, step->pipeline);
    etch_scene_elements_assemble(step, run->collect != NULL ? run->collect : &sink.raster.sink);
}

const struct etch_scene_statement etch_scene_elements_statements[] = {
    {"list", read_list, draw_triangles, NULL, NULL},
    {"vertex", read_vertex, NULL, NULL, NULL},
    {"index", read_index, NULL, NULL, NULL},
    {"endlist", read_end, NULL, NULL, NULL},
    {"primitive", etch_scene_read_primitive, NULL, NULL, NULL},
    {NULL, NULL, NULL, NULL, NULL},
};
