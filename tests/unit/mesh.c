/* tests/unit: the mesh pipeline: what reaches the sink. */
#include "core/fragment/flat.h"
#include "tests/harness/canvas.h"
#include "tests/unit/mesh_parts.h"

void suite_mesh(void);

/* ---- a sink that stores ---------------------------------------------------------------------- */

#define MOST_STORED 512

struct stored {
    struct etch_vertex v[3];
};

struct store_sink {
    struct etch_sink sink;
    int n;
    struct stored triangle[MOST_STORED];
};

static void store(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    struct store_sink *s = (struct store_sink *)(void *)sink;
    int i;

    if (!CHECK(s->n < MOST_STORED))
        return;
    for (i = 0; i < 3; i++)
        s->triangle[s->n].v[i] = *v[i];
    s->n++;
}

static struct test_canvas canvas;
static struct store_sink stored, other;

static void store_init(struct store_sink *s)
{
    s->sink.triangle = store;
    s->n = 0;
}

static bool same_vertex(const struct etch_vertex *a, const struct etch_vertex *b)
{
    return a->x_q8 == b->x_q8 && a->y_q8 == b->y_q8 && a->z_q16 == b->z_q16 && a->r == b->r &&
           a->g == b->g && a->b == b->b && a->a == b->a;
}

static bool same_stream(const struct store_sink *a, const struct store_sink *b)
{
    int i;

    if (a->n != b->n)
        return false;
    for (i = 0; i < 3 * a->n; i++)
        if (!same_vertex(&a->triangle[i / 3].v[i % 3], &b->triangle[i / 3].v[i % 3]))
            return false;
    return true;
}

/* ---- cases ----------------------------------------------------------------------------------- */

/* From before each face exactly that face's side is kept: counted by the exact orientation of
 * the eye to each face plane x + y + z = 1 and its mirrors. */
static void culling_keeps_what_faces_the_eye(void)
{
    uint32_t seed = 3;
    int32_t n;

    for (n = 0; n < TEST_COUNT(5000); n++) {
        static const struct etch_vector centre = {0, 0, 0};
        struct etch_assembly assembly = assembly_for(&stored.sink, screen);
        const struct etch_vector eye = {test_range(&seed, -300000, 300000), 100000,
                                        test_range(&seed, -300000, 300000)};
        const struct etch_matrix m = camera(&eye, &centre, 655, 40 * 65536);
        struct etch_mesh_stage stage;
        int expected = 0, unclear = 0, face;

        for (face = 0; face < 8; face++) {
            const int32_t side = ((face & 1) != 0 ? eye.x : -eye.x) +
                                 ((face & 2) != 0 ? eye.y : -eye.y) +
                                 ((face & 4) != 0 ? eye.z : -eye.z) - 64000; /* 1000 / 1024 */

            expected += side > 0;
            unclear += side > -4000 && side < 4000; /* nearly edge-on */
        }
        store_init(&stored);
        etch_mesh_stage_init(&stage, &octahedron, &m, etch_vertex_plain, NULL);
        assembly.cull = ETCH_CULL_CLOCKWISE;
        CHECK_EQ(etch_mesh_draw(&stage, &assembly, buffer, 6), ETCH_OK);
        if (unclear == 0)
            CHECK_EQ(stored.n, expected);
        store_init(&stored);
        assembly.cull = ETCH_CULL_COUNTER_CLOCKWISE;
        CHECK_EQ(etch_mesh_draw(&stage, &assembly, buffer, 6), ETCH_OK);
        if (unclear == 0)
            CHECK_EQ(stored.n, 8 - expected);
    }
}

/* A mesh gives the triangles that its vertices give one by one, and the two halves apart, run
 * any number of times, what the whole gives. */
static void halves_equal_the_whole(void)
{
    uint32_t seed = 4;
    int32_t n, t;

    for (n = 0; n < TEST_COUNT(200); n++) {
        static const struct etch_vector centre = {0, -30000, 0};
        struct etch_assembly assembly = assembly_for(&stored.sink, screen);
        const struct etch_vector eye = {test_range(&seed, -300000, 300000),
                                        test_range(&seed, 1, 60000), 100000};
        const struct etch_matrix m = camera(&eye, &centre, 6553, 40 * 65536);
        struct etch_mesh_stage stage;

        make_grid(20 + n % 40, &seed);
        etch_mesh_stage_init(&stage, &grid, &m, etch_vertex_plain, NULL);
        assembly.cull = (enum etch_cull)(n % 3);
        assembly.flat = n % 2 == 0;
        store_init(&stored);
        CHECK_EQ(etch_mesh_draw(&stage, &assembly, buffer, GRID * GRID), ETCH_OK);

        store_init(&other);
        assembly.sink = &other.sink;
        for (t = 0; t < grid.triangle_count; t++) {
            struct etch_clip_vertex v[3];
            int i;

            for (i = 0; i < 3; i++)
                etch_vertex_plain(&stage, grid_indices[3 * t + i], &v[i]);
            etch_assemble_triangle(&assembly, v);
        }
        CHECK(same_stream(&stored, &other));

        etch_mesh_transform(&stage, &assembly.viewport, buffer);
        for (t = 0; t < 2; t++) {
            store_init(&other);
            etch_mesh_assemble(&stage, &assembly, buffer);
            CHECK(same_stream(&stored, &other));
        }
        CHECK((stored.n > 0) == (assembly.cull != ETCH_CULL_COUNTER_CLOCKWISE));
        if (assembly.flat)
            for (t = 0; t < stored.n; t++)
                CHECK(stored.triangle[t].v[1].r == stored.triangle[t].v[0].r &&
                      stored.triangle[t].v[2].g == stored.triangle[t].v[0].g);
    }
}

/* Indices beyond the mesh skip their triangle; the buffer's entries behind it stay unread (they
 * hold a triangle that would be seen). */
static void wrong_indices_are_skipped(void)
{
    static const uint16_t indices[] = {0, 2, 4, 0, 2, 6, 65535, 1, 2, 0, 7, 4, 2, 1, 4};
    const struct etch_mesh broken = {octa_positions, NULL, NULL, indices, 6, 5, 1000, 10};
    static const struct etch_vector centre = {0, 0, 0}, eye = {30000, 20000, 300000};
    const struct etch_matrix m = camera(&eye, &centre, 655, 40 * 65536);
    const struct etch_assembly assembly = assembly_for(&stored.sink, screen);
    struct etch_mesh_stage stage;

    store_init(&stored);
    etch_mesh_stage_init(&stage, &broken, &m, etch_vertex_plain, NULL);
    buffer[6].out = buffer[7].out = 0;
    buffer[6].v.x_q8 = buffer[7].v.x_q8 = 40;
    buffer[6].v.y_q8 = buffer[7].v.y_q8 = 9999;
    CHECK_EQ(etch_mesh_draw(&stage, &assembly, buffer, 6), ETCH_OK);
    CHECK_EQ(stored.n, 2);
}

static void small_buffers_are_refused(void)
{
    struct etch_matrix m;
    const struct etch_assembly assembly = assembly_for(&stored.sink, screen);
    struct etch_mesh_stage stage;

    store_init(&stored);
    etch_matrix_identity(&m);
    etch_mesh_stage_init(&stage, &octahedron, &m, etch_vertex_plain, NULL);
    CHECK_EQ(etch_mesh_draw(&stage, &assembly, buffer, 5), ETCH_ENOMEM);
    CHECK_EQ(stored.n, 0);
    CHECK_EQ(sizeof(struct etch_mesh_vertex), 20);
}

/* Vertex colours: mesh times stage over 255; lit, as light.h says with that colour; without
 * normals ambient alone. */
static void vertex_functions_color(void)
{
    struct etch_light light = {0, 0, 16513, {200, 100, 50}};
    const struct etch_lighting lighting = {{30, 20, 10}, 1, &light};
    struct etch_matrix m;
    struct etch_mesh_stage stage;
    uint16_t i;

    etch_matrix_identity(&m);
    etch_mesh_stage_init(&stage, &octahedron, &m, etch_vertex_lit, &lighting);
    stage.color[0] = 128;
    stage.color[3] = 77;
    for (i = 0; i < 6; i++) {
        const int8_t normal[3] = {octa_normals[3 * i], octa_normals[3 * i + 1],
                                  octa_normals[3 * i + 2]};
        uint8_t rgb[3] = {128, 255, 255};
        struct etch_clip_vertex v;

        etch_light_vertex(&lighting, normal, rgb);
        etch_vertex_lit(&stage, i, &v);
        CHECK(v.r == rgb[0] && v.g == rgb[1] && v.b == rgb[2] && v.a == 77);
        CHECK_EQ(v.x, octa_positions[3 * i] * 64);
        CHECK_EQ(v.w, 65536);
    }
    etch_mesh_stage_init(&stage, &grid, &m, etch_vertex_lit, &lighting);
    for (i = 0; i < GRID * GRID; i++) {
        const int8_t none[3] = {0, 0, 0};
        uint8_t rgb[3] = {grid_colors[3 * i], grid_colors[3 * i + 1], grid_colors[3 * i + 2]};
        struct etch_clip_vertex v;

        etch_vertex_plain(&stage, i, &v);
        CHECK(v.r == rgb[0] && v.g == rgb[1] && v.b == rgb[2] && v.a == 255);
        etch_light_vertex(&lighting, none, rgb);
        etch_vertex_lit(&stage, i, &v);
        CHECK(v.r == rgb[0] && v.g == rgb[1] && v.b == rgb[2] && v.a == 255);
    }
}

static int64_t doubled_area(const struct etch_vertex *a, const struct etch_vertex *b,
                            const struct etch_vertex *c)
{
    return (int64_t)(b->x_q8 - a->x_q8) * (c->y_q8 - a->y_q8) -
           (int64_t)(b->y_q8 - a->y_q8) * (c->x_q8 - a->x_q8);
}

/* Convex quadrilaterals with a corner a hair outside the line through its neighbours: snapping
 * makes it reflex as often as not. No triangle of the fan turns over, and they sum to the
 * snapped outline, whichever corner comes first. */
static void fans_do_not_fold(void)
{
    static const struct etch_rect square = {0, 0, 256, 256};
    const int32_t w = INT32_C(1) << 24; /* 512 units of x or y are 1/256 px */
    const struct etch_assembly assembly = assembly_for(&stored.sink, square);
    uint32_t seed = 6;
    int32_t n, reflex = 0;

    for (n = 0; n < TEST_COUNT(50000); n++) {
        const int32_t x = test_range(&seed, w / 9, w), y = test_range(&seed, -w / 3, w / 3);
        const int32_t part = test_range(&seed, 1, 255), hair = test_range(&seed, 0, 300);
        const struct etch_clip_vertex corner[4] = {
            {0, 0, 0, w, 0, 0, 0, 0},
            {x / 256 * part, y / 256 * part - hair, 0, w, 0, 0, 0, 0},
            {x, y, 0, w, 0, 0, 0, 0},
            {x / 2, y + w / 3, 0, w, 0, 0, 0, 0}};
        struct etch_clip_vertex turned[4];
        struct etch_vertex v[4];
        int64_t sum = 0;
        int i;

        for (i = 0; i < 4; i++) {
            turned[i] = corner[(i + n) % 4];
            etch_viewport_project(&assembly.viewport, &turned[i], &v[i]);
        }
        const int64_t outline = doubled_area(&v[0], &v[1], &v[2]) +
                                doubled_area(&v[0], &v[2], &v[3]);

        store_init(&stored);
        etch_assemble_fan(&assembly, turned, 4);
        for (i = 0; i < stored.n; i++) {
            const struct etch_vertex *t = stored.triangle[i].v;
            const int64_t area = doubled_area(&t[0], &t[1], &t[2]);

            CHECK((area < 0) == (outline < 0));
            sum += area;
        }
        CHECK_EQ(sum, outline);
        for (i = 0; i < 4; i++)
            reflex += (doubled_area(&v[i], &v[(i + 1) % 4], &v[(i + 2) % 4]) > 0) != (outline > 0);
    }
    CHECK(reflex > n / 20);
}

/* The rasterising sink draws what the painter draws. */
static void raster_sink_paints(void)
{
    static const struct etch_rect small = {0, 0, 8, 6};
    struct etch_raster_sink raster;
    struct etch_assembly assembly;
    const struct etch_clip_vertex v[3] = {{-65536, 65536, 0, 65536, 255, 255, 255, 255},
                                          {-65536, -65536, 0, 65536, 255, 255, 255, 255},
                                          {65536, -65536, 0, 65536, 255, 255, 255, 255}};

    test_canvas_open(&canvas, small);
    etch_raster_sink_init(&raster, &canvas.surface, etch_triangle_flat, etch_kernel_flat);
    assembly = assembly_for(&raster.sink, small);
    assembly.cull = ETCH_CULL_CLOCKWISE;
    etch_assemble_triangle(&assembly, v);
    CHECK_PICTURE(&canvas, "#......."
                           "##......"
                           "###....."
                           "#####..."
                           "######.."
                           "#######.");
    CHECK_ONCE(&canvas);
}

void suite_mesh(void)
{
    RUN(culling_keeps_what_faces_the_eye);
    RUN(halves_equal_the_whole);
    RUN(wrong_indices_are_skipped);
    RUN(small_buffers_are_refused);
    RUN(vertex_functions_color);
    RUN(fans_do_not_fold);
    RUN(raster_sink_paints);
}
