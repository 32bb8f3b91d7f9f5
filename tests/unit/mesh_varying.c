/* tests/unit: meshes with texture coordinates: what reaches the sink. */
#include "core/draw/mesh_varying.h"
#include "tests/unit/mesh_parts.h"

void suite_mesh_varying(void);

#define MOST_STORED 1024

struct store_sink {
    struct etch_sink sink;
    int n;
    struct etch_texture_vertex v[MOST_STORED][3];
};

static void store(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    struct store_sink *s = (struct store_sink *)(void *)sink;

    if (!CHECK(s->n < MOST_STORED))
        return;
    for (int i = 0; i < 3; i++)
        s->v[s->n][i] = *(const struct etch_texture_vertex *)(const void *)v[i];
    s->n++;
}

static void store_plain(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    struct store_sink *s = (struct store_sink *)(void *)sink;

    if (!CHECK(s->n < MOST_STORED))
        return;
    for (int i = 0; i < 3; i++)
        s->v[s->n][i].at = *v[i];
    s->n++;
}

static struct store_sink whole = {.sink.triangle = store}, one = {.sink.triangle = store};
static struct store_sink plain = {.sink.triangle = store_plain};
static int16_t coordinates[GRID * GRID * 2];
static struct etch_mesh_texture_vertex textured[GRID * GRID + 1];

static bool same_at(const struct etch_vertex *a, const struct etch_vertex *b)
{
    return a->x_q8 == b->x_q8 && a->y_q8 == b->y_q8 && a->z_q16 == b->z_q16 && a->r == b->r &&
           a->g == b->g && a->b == b->b && a->a == b->a;
}

static bool same(const struct etch_texture_vertex *a, const struct etch_texture_vertex *b)
{
    return same_at(&a->at, &b->at) && a->u == b->u && a->v == b->v && a->w == b->w;
}

static void stage_for(struct etch_mesh_texture_stage *stage, const struct etch_matrix *m)
{
    stage->inner = etch_vertex_plain;
    stage->coordinates = coordinates;
    stage->scale_u = 1024;
    stage->scale_v = -65536 * 3;
    etch_mesh_stage_init(&stage->stage, &grid, m, etch_vertex_textured, NULL);
}

/* Every triangle by itself through etch_assemble_textured. */
static void assemble_one_by_one(const struct etch_mesh_texture_stage *stage,
                                const struct etch_assembly *assembly)
{
    for (int32_t t = 0; t < grid.triangle_count; t++) {
        struct etch_clip_texture_vertex v[3];

        for (int i = 0; i < 3; i++) {
            const uint16_t index = grid_indices[3 * t + i];

            etch_vertex_textured(&stage->stage, index, &v[i].at);
            CHECK_EQ(v[i].u, coordinates[2 * index] * 1024);
            CHECK_EQ(v[i].v, etch_saturate_s32(INT64_C(-196608) * coordinates[2 * index + 1]));
        }
        etch_assemble_textured(assembly, v);
    }
}

/* A textured mesh gives the triangles that its vertices give one by one, at the positions and in
 * the colours of the mesh without a texture. */
static void mesh_is_its_triangles(void)
{
    uint32_t seed = 4;

    for (int32_t n = 0; n < TEST_COUNT(100) && !test_failed(); n++) {
        static const struct etch_vector centre = {0, -30000, 0};
        struct etch_assembly assembly = assembly_for(&whole.sink, screen);
        const struct etch_vector eye = {test_range(&seed, -300000, 300000),
                                        test_range(&seed, 1, 60000), 100000};
        const struct etch_matrix m = camera(&eye, &centre, 6553, 40 * 65536);
        struct etch_mesh_texture_stage stage;
        struct etch_mesh_stage bare;

        make_grid(20 + n % 40, &seed);
        for (int i = 0; i < GRID * GRID * 2; i++)
            coordinates[i] = (int16_t)test_range(&seed, -32768, 32767);
        assembly.cull = (enum etch_cull)(n % 3);
        assembly.flat = n % 2 == 0;
        whole.n = one.n = plain.n = 0;
        stage_for(&stage, &m);
        CHECK_EQ(etch_mesh_draw_textured(&stage.stage, &assembly, textured, GRID * GRID), ETCH_OK);
        assembly.sink = &one.sink;
        assemble_one_by_one(&stage, &assembly);
        assembly.sink = &plain.sink;
        etch_mesh_stage_init(&bare, &grid, &m, etch_vertex_plain, NULL);
        CHECK_EQ(etch_mesh_draw(&bare, &assembly, buffer, GRID * GRID), ETCH_OK);

        CHECK_EQ(one.n, whole.n);
        CHECK_EQ(plain.n, whole.n);
        for (int i = 0; i < 3 * whole.n && !test_failed(); i++) {
            CHECK(same(&whole.v[i / 3][i % 3], &one.v[i / 3][i % 3]));
            CHECK(same_at(&whole.v[i / 3][i % 3].at, &plain.v[i / 3][i % 3].at));
        }
    }
}

static void short_buffer_draws_nothing(void)
{
    static const struct etch_vector eye = {0, 60000, 100000}, centre = {0, 0, 0};
    const struct etch_assembly assembly = assembly_for(&whole.sink, screen);
    const struct etch_matrix m = camera(&eye, &centre, 6553, 40 * 65536);
    struct etch_mesh_texture_stage stage;
    uint32_t seed = 1;

    make_grid(20, &seed);
    stage_for(&stage, &m);
    whole.n = 0;
    textured[GRID * GRID].out = 0xA5A5;
    CHECK_EQ(etch_mesh_draw_textured(&stage.stage, &assembly, textured, GRID * GRID - 1),
             ETCH_ENOMEM);
    CHECK_EQ(whole.n, 0);
    CHECK_EQ(etch_mesh_draw_textured(&stage.stage, &assembly, textured, GRID * GRID), ETCH_OK);
    CHECK(whole.n > 0);
    CHECK_EQ(textured[GRID * GRID].out, 0xA5A5);
}

void suite_mesh_varying(void)
{
    RUN(mesh_is_its_triangles);
    RUN(short_buffer_draws_nothing);
}
