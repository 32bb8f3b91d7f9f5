/* tests/unit: the vertex functions of lamps: what the stage makes of model, normals and colours. */
#include "core/draw/mesh_shaded.h"
#include "tests/unit/mesh_parts.h"

void suite_mesh_shaded(void);

static struct etch_shade_point seen;

/* Notes what it is asked to shade. */
static void note_point(const void *lighting, const struct etch_shade_point *point, uint8_t rgb[3])
{
    CHECK(lighting == &seen);
    seen = *point;
    rgb[0] = (uint8_t)(255 - rgb[0]);
}

/* A model that is scaled unevenly, mirrored and moved: the point is the vertex in the world, the
 * normal is at right angles to the scaled octahedron, on its outer side. */
static void vertices_stand_in_the_world(void)
{
    struct etch_matrix scale, move, model, clip;
    struct etch_mesh_shaded_stage stage;

    etch_matrix_identity(&clip);
    etch_matrix_scale(&scale, -65536, 3 * 65536, 32768);
    etch_matrix_translate(&move, 10 * 65536, 20 * 65536, -65536);
    CHECK_EQ(etch_matrix_multiply(&model, &move, &scale), ETCH_OK);
    CHECK_EQ(etch_mesh_shaded_init(&stage, &octahedron, &clip, &model, note_point, &seen), ETCH_OK);
    for (uint16_t i = 0; i < octahedron.vertex_count; i++) {
        const int16_t *p = &octa_positions[i * 3];
        const int8_t *n = &octa_normals[i * 3];
        struct etch_clip_vertex v;
        struct etch_clip_shade_vertex wide;

        stage.stage.vertex(&stage.stage, i, &v);
        CHECK_EQ(seen.position[0], 10 * 65536 - p[0] * 64);
        CHECK_EQ(seen.position[1], 20 * 65536 + p[1] * 192);
        CHECK_EQ(seen.position[2], -65536 + p[2] * 32);
        CHECK_EQ(seen.normal[0], n[0] == 0 ? 0 : n[0] > 0 ? -16384 : 16384);
        CHECK_EQ(seen.normal[1], n[1] == 0 ? 0 : n[1] > 0 ? 16384 : -16384);
        CHECK_EQ(seen.normal[2], n[2] == 0 ? 0 : n[2] > 0 ? 16384 : -16384);
        CHECK(v.r == 0 && v.g == 255 && v.b == 255 && v.a == 255);

        etch_vertex_normal(&stage.stage, i, &wide.at.at);
        CHECK(wide.at.at.x == v.x && wide.at.at.y == v.y && wide.at.at.z == v.z &&
              wide.at.at.w == v.w && wide.at.at.r == 255);
        for (int k = 0; k < 3; k++) {
            CHECK_EQ(wide.normal[k], seen.normal[k]);
            CHECK_EQ(wide.position[k], seen.position[k]);
        }
    }
}

static int32_t triangles;

static void check_color(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    (void)sink;
    triangles++;
    for (int i = 0; i < 3; i++)
        CHECK(v[i]->r == 0 && v[i]->g == 255);
}

/* A stage of lamps is a stage like others to etch_mesh_draw. */
static void meshes_are_drawn_with_it(void)
{
    static const struct etch_vector eye = {200000, 100000, 200000}, centre = {0, 0, 0};
    struct etch_sink sink = {.triangle = check_color};
    const struct etch_assembly assembly = assembly_for(&sink, screen);
    const struct etch_matrix clip = camera(&eye, &centre, 655, 40 * 65536);
    struct etch_mesh_shaded_stage stage;
    struct etch_matrix model;

    etch_matrix_identity(&model);
    CHECK_EQ(etch_mesh_shaded_init(&stage, &octahedron, &clip, &model, note_point, &seen), ETCH_OK);
    CHECK_EQ(etch_mesh_draw(&stage.stage, &assembly, buffer, 6), ETCH_OK);
    CHECK_EQ(triangles, 8);
}

static void mesh_without_normals_has_none(void)
{
    struct etch_matrix m;
    struct etch_mesh_shaded_stage stage;
    struct etch_clip_vertex v;
    uint32_t seed = 1;

    make_grid(20, &seed);
    etch_matrix_identity(&m);
    CHECK_EQ(etch_mesh_shaded_init(&stage, &grid, &m, &m, note_point, &seen), ETCH_OK);
    stage.stage.vertex(&stage.stage, 5, &v);
    CHECK(seen.normal[0] == 0 && seen.normal[1] == 0 && seen.normal[2] == 0);
    CHECK_EQ(v.r, 255 - grid_colors[15]);
    etch_matrix_scale(&m, 0, 0, 65536);
    CHECK_EQ(etch_mesh_shaded_init(&stage, &grid, &m, &m, note_point, &seen), ETCH_EINVAL);
}

void suite_mesh_shaded(void)
{
    RUN(vertices_stand_in_the_world);
    RUN(meshes_are_drawn_with_it);
    RUN(mesh_without_normals_has_none);
}
