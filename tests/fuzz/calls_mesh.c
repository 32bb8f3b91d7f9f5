/* tests/fuzz: from clip space to the surface: assembly, meshes, elements, and the sinks that keep,
 * sort, name or give back primitives. */
#include "calls.h"

#include "core/draw/mesh_small.h"
#include "core/vertex/assembly_small.h"

static struct etch_raster_sink raster;

/* A sink that draws on the surface, an assembly of a viewport near it, any culling. */
static struct etch_assembly assembly(struct fuzz_calls *c)
{
    const uint8_t kind = fuzz_byte(c);
    struct etch_assembly a = {.cull = (enum etch_cull)(kind % 3), .flat = kind >= 128};

    if (etch_viewport_init(&a.viewport, kind % 8 < 5 ? c->s.window : fuzz_rect(c)) != ETCH_OK) {
        (void)etch_viewport_init(&a.viewport, c->s.window);
    }
    etch_raster_sink_init(&raster, &c->s, etch_triangle_gouraud_depth, etch_kernel_gouraud_less);
    a.sink = &raster.sink;
    return a;
}

static struct etch_clip_vertex clip_vertex(struct fuzz_calls *c)
{
    struct etch_clip_vertex v = {.x = fuzz_s32(c)};
    const uint8_t near = fuzz_byte(c);

    v.y = fuzz_s32(c), v.z = fuzz_s32(c);
    v.w = near < 32 ? 0 : near < 64 ? 1 : near < 160 ? 65536 : near < 192 ? INT32_MAX : fuzz_s32(c);
    v.r = near, v.g = (uint8_t)(near * 3), v.b = 200, v.a = 255;
    return v;
}

static void triangle(struct fuzz_calls *c, fuzz_function *f)
{
    const struct etch_assembly a = assembly(c);
    const struct etch_clip_vertex v[3] = {clip_vertex(c), clip_vertex(c), clip_vertex(c)};

    ((void (*)(const struct etch_assembly *, const struct etch_clip_vertex *))f)(&a, v);
}

static void line_and_point(struct fuzz_calls *c, fuzz_function *f)
{
    struct etch_assembly a = assembly(c);
    const struct etch_clip_vertex v[2] = {clip_vertex(c), clip_vertex(c)};
    struct etch_line_sink lines;
    struct etch_point_sink points;

    etch_line_sink_init(&lines, &c->s, etch_line_gouraud_depth, etch_kernel_gouraud_less);
    etch_point_sink_init(&points, &c->s, fuzz_word(c), etch_point_runs_round,
                         etch_kernel_gouraud_less);
    a.sink = f == (fuzz_function *)etch_assemble_line ? &lines.sink : &points.sink;
    ((void (*)(const struct etch_assembly *, const struct etch_clip_vertex *))f)(&a, v);
}

static void textured(struct fuzz_calls *c, fuzz_function *f)
{
    static const uint16_t texels[8] = {1, 2, 3, 4, 5, 6, 7, 8};
    const struct etch_texture texture = {texels, 2, 1};
    struct etch_assembly a = assembly(c);
    struct etch_clip_texture_vertex v[3];
    struct etch_texture_sink sink;

    (void)f;
    for (int i = 0; i < 3; i++) {
        v[i].at = clip_vertex(c);
        v[i].u = (etch_q16)(fuzz_byte(c) * INT32_C(8388608) - INT32_C(1000000000));
        v[i].v = v[i].at.x;
    }
    etch_texture_sink_init(&sink, &c->s, &texture, etch_triangle_perspective_depth,
                           &etch_perspective_less);
    a.sink = &sink.sink;
    etch_assemble_textured(&a, v);
}

/* ---- meshes: positions and indices out of the bytes, some beyond the mesh ----------------------
 * */

#define VERTICES 5
#define TRIANGLES 4

static int16_t positions[VERTICES * 3];
static uint16_t indices[TRIANGLES * 3];
static struct etch_mesh mesh = {positions, NULL, NULL, indices, VERTICES, TRIANGLES, 32768, 0};

static struct etch_matrix matrix(struct fuzz_calls *c)
{
    struct etch_matrix m;

    etch_matrix_scale(&m, 256, 256, 256);
    for (int i = 0; i < 3; i++) {
        m.m[i][fuzz_byte(c) % 4] = fuzz_s32(c);
    }
    m.m[3][2] = -256;
    m.m[3][3] = fuzz_byte(c) < 128 ? 65536 : fuzz_s32(c);
    return m;
}

static void read_mesh(struct fuzz_calls *c)
{
    mesh.bits = fuzz_byte(c) % 16;
    for (int i = 0; i < TRIANGLES * 3; i++) {
        const uint8_t index = fuzz_byte(c);

        indices[i] = index == 255 ? UINT16_MAX : index % (VERTICES + 1);
    }
    for (int i = 0; i < VERTICES * 3; i++) {
        positions[i] = (int16_t)((fuzz_byte(c) - 128) * 256);
    }
}

static void whole_mesh(struct fuzz_calls *c, fuzz_function *f)
{
    struct etch_mesh_vertex *buffer = fuzz_memory(VERTICES * sizeof *buffer);
    const struct etch_assembly a = assembly(c);
    const struct etch_matrix m = matrix(c);
    struct etch_mesh_stage stage;

    read_mesh(c);
    etch_mesh_stage_init(&stage, &mesh, &m, etch_vertex_plain, NULL);
    if (f == (fuzz_function *)etch_mesh_draw_small) {
        etch_mesh_draw_small(&stage, &a);
    } else if (f == (fuzz_function *)etch_mesh_assemble) {
        etch_mesh_transform(&stage, &a.viewport, buffer);
        etch_mesh_assemble(&stage, &a, buffer);
    } else if (etch_mesh_draw(&stage, &a, buffer, VERTICES) != ETCH_OK) {
        fuzz_fail("a mesh is refused");
    }
}

static void textured_mesh(struct fuzz_calls *c, fuzz_function *f)
{
    static const uint16_t texels[8] = {1, 2, 3, 4, 5, 6, 7, 8};
    const struct etch_texture texture = {texels, 2, 1};
    struct etch_mesh_texture_vertex *buffer = fuzz_memory(VERTICES * sizeof *buffer);
    struct etch_assembly a = assembly(c);
    const struct etch_matrix m = matrix(c);
    struct etch_mesh_texture_stage stage;
    struct etch_texture_sink sink;

    (void)f;
    read_mesh(c);
    etch_mesh_stage_init(&stage.stage, &mesh, &m, etch_vertex_textured, NULL);
    stage.inner = etch_vertex_plain;
    stage.coordinates = positions;
    stage.scale_u = fuzz_s32(c), stage.scale_v = fuzz_s32(c);
    etch_texture_sink_init(&sink, &c->s, &texture, etch_triangle_perspective_depth,
                           &etch_perspective_lequal);
    a.sink = &sink.sink;
    if (etch_mesh_draw_textured(&stage.stage, &a, buffer, VERTICES) != ETCH_OK) {
        fuzz_fail("a mesh is refused");
    }
}

static void elements(struct fuzz_calls *c, fuzz_function *f)
{
    struct etch_mesh_vertex *buffer = fuzz_memory(VERTICES * sizeof *buffer);
    struct etch_assembly a = assembly(c);
    const struct etch_matrix m = matrix(c);
    const struct etch_elements of = {fuzz_byte(c) < 64 ? NULL : indices, fuzz_below(c, 13),
                                     VERTICES};
    struct etch_mesh_stage stage;
    struct etch_mesh_elements to;
    struct etch_line_sink lines;
    struct etch_point_sink points;
    const bool point = f == (fuzz_function *)etch_elements_points;
    const bool line = f == (fuzz_function *)etch_elements_lines ||
                      f == (fuzz_function *)etch_elements_line_strip ||
                      f == (fuzz_function *)etch_elements_line_loop;

    read_mesh(c);
    etch_line_sink_init(&lines, &c->s, etch_line_gouraud, etch_kernel_gouraud);
    etch_point_sink_init(&points, &c->s, 700, etch_point_runs_square, etch_kernel_gouraud);
    a.sink = point ? &points.sink : line ? &lines.sink : a.sink;
    etch_mesh_stage_init(&stage, &mesh, &m, etch_vertex_plain, NULL);
    etch_mesh_transform(&stage, &a.viewport, buffer);
    etch_mesh_elements_init(&to,
                            point  ? etch_mesh_take_point
                            : line ? etch_mesh_take_line
                                   : etch_mesh_take_triangle,
                            &stage, &a, buffer);
    ((etch_element_kind *)f)(&of, &to.sink);
}

/* ---- what keeps primitives ------------------------------------------------------------------- */

/* Three triangles to a sink. */
static void feed(struct fuzz_calls *c, struct etch_sink *sink)
{
    for (int i = 0; i < 3; i++) {
        const struct etch_vertex v[3] = {fuzz_vertex(c), fuzz_vertex(c), fuzz_vertex(c)};
        const struct etch_vertex *const p[3] = {&v[0], &v[1], &v[2]};

        sink->triangle(sink, p);
    }
}

static void retained(struct fuzz_calls *c, fuzz_function *f)
{
    struct etch_retained_triangle *room = fuzz_memory(2 * sizeof *room);
    struct etch_retained r;

    (void)f;
    etch_retained_init(&r, fuzz_byte(c) < 128 ? c->s.window : fuzz_rect(c),
                       etch_kernel_gouraud_less, room, (uint16_t)(1 + fuzz_byte(c) % 2));
    feed(c, &r.sink);
    etch_retained_draw(&r, &c->s);
}

static void ordering(struct fuzz_calls *c, fuzz_function *f)
{
    const uint16_t buckets = (uint16_t)(1 + fuzz_byte(c));
    struct etch_ordered *room = fuzz_memory(3 * sizeof *room);
    struct etch_ordering o;

    (void)f;
    (void)assembly(c);
    etch_ordering_init(&o, room, fuzz_below(c, 4), fuzz_memory(buckets * sizeof(uint16_t)),
                       buckets);
    feed(c, &o.sink);
    etch_ordering_draw(&o, &raster.sink);
}

static void painter(struct fuzz_calls *c, fuzz_function *f)
{
    const uint16_t most = fuzz_below(c, 24);
    struct etch_painter_triangle *room = fuzz_memory(most * sizeof *room);
    struct etch_painter p;

    (void)f;
    (void)assembly(c);
    etch_painter_init(&p, room, most);
    feed(c, &p.sink);
    (void)etch_painter_sort(&p);
    etch_painter_draw(&p, &raster.sink);
}

/* Sinks that name, move and give back. */
static void sinks(struct fuzz_calls *c, fuzz_function *f)
{
    struct etch_feedback_primitive *room = fuzz_memory(2 * sizeof *room);
    struct etch_feedback feedback;
    struct etch_jitter_sink jitter;
    struct etch_name_sink names;

    (void)f;
    etch_name_sink_init(&names, &c->s, etch_kernel_flat_less);
    names.name = fuzz_word(c);
    etch_jitter_sink_init(&jitter, &names.sink, etch_jitter_16[fuzz_byte(c) % 16]);
    feed(c, &jitter.sink);
    etch_feedback_init(&feedback, room, 2);
    feed(c, &feedback.sink);
    if (etch_feedback_status(&feedback) != ETCH_ENOMEM) {
        fuzz_fail("three primitives in the place of two");
    }
}

#define ROW(name, call)                                                                            \
    {                                                                                              \
#name, call, (fuzz_function *)name                                                         \
    }

const struct fuzz_row fuzz_mesh_rows[] = {
    ROW(etch_assemble_triangle, triangle),
    ROW(etch_assemble_triangle_small, triangle),
    ROW(etch_assemble_line, line_and_point),
    ROW(etch_assemble_point, line_and_point),
    {"etch_assemble_textured", textured, NULL},
    ROW(etch_mesh_draw, whole_mesh),
    ROW(etch_mesh_draw_small, whole_mesh),
    ROW(etch_mesh_assemble, whole_mesh),
    {"etch_mesh_draw_textured", textured_mesh, NULL},
    ROW(etch_elements_points, elements),
    ROW(etch_elements_lines, elements),
    ROW(etch_elements_line_strip, elements),
    ROW(etch_elements_line_loop, elements),
    ROW(etch_elements_triangles, elements),
    ROW(etch_elements_triangle_strip, elements),
    ROW(etch_elements_triangle_fan, elements),
    {"etch_retained_draw", retained, NULL},
    {"etch_ordering_draw", ordering, NULL},
    {"etch_painter_draw", painter, NULL},
    {"etch_name_sink_init", sinks, NULL},
    {NULL, NULL, NULL},
};
