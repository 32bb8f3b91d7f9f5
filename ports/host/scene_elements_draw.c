/* ports/host/scene_elements_draw.c: assembles and draws the lists of vertices that scene_elements.c
 * reads: once for every strip. */
#include "scene_elements.h"
#include "scene_lines.h"
#include "scene_primitive.h"

static etch_scene_draw_function draw_points, draw_lines, draw_triangles;

#define PRIMITIVE "etch_mesh_primitive_init "
#define LINES "etch_mesh_transform etch_mesh_take_line "
#define TRIANGLES "etch_mesh_transform etch_mesh_take_triangle "
const struct etch_scene_element_kind etch_scene_element_kinds[ETCH_SCENE_ELEMENTS] = {
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
