/* tests/unit: the small vertex stage against its fast sibling: the same bits where nothing is
 * clipped, corners within their bound where something is, and the stated errors elsewhere. */
#include "core/draw/mesh_small.h"
#include "core/vertex/assembly_small.h"
#include "core/vertex/light_small.h"
#include "core/vertex/project_small.h"
#include "core/vertex/rotate_small.h"
#include "tests/harness/harness.h"

void suite_mesh_small(void);

/* Keeps what a sink gets. */
#define MOST 64
struct record {
    struct etch_sink sink;
    int count;
    struct etch_vertex v[MOST][3];
};

static void take(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    struct record *const r = (struct record *)(void *)sink;
    int i;

    for (i = 0; i < 3 && r->count < MOST; i++)
        r->v[r->count][i] = *v[i];
    r->count += r->count < MOST;
}

static struct record fast, small;

static bool same_vertex(const struct etch_vertex *a, const struct etch_vertex *b)
{
    return a->x_q8 == b->x_q8 && a->y_q8 == b->y_q8 && a->z_q16 == b->z_q16 && a->r == b->r &&
           a->g == b->g && a->b == b->b && a->a == b->a;
}

static void compare_records(void)
{
    int i, k;

    CHECK_EQ(small.count, fast.count);
    for (i = 0; i < fast.count && i < small.count; i++)
        for (k = 0; k < 3; k++)
            CHECK(same_vertex(&small.v[i][k], &fast.v[i][k]));
}

static const struct etch_rect rects[] = {
    {0, 0, 320, 240}, {-20, 10, 300, 31}, {0, 0, 1, 1}, {-32768, -32768, 32767, 32767}};

/* A vertex with w of any size up to 2^bits, mostly within 2^11 of that. */
static struct etch_clip_vertex make_vertex(uint32_t *seed, int bits, int32_t reach)
{
    const int32_t w = (int32_t)(test_random(seed) >>
                                (32 - test_range(seed, bits > 12 ? bits - 10 : 1, bits))) +
                      1;
    struct etch_clip_vertex v = {0, 0, 0, w, 0, 0, 0, 255};
    etch_q16 *const axis[3] = {&v.x, &v.y, &v.z};
    int i;

    for (i = 0; i < 3; i++) {
        const int64_t most = (int64_t)w * reach / 4;
        const int32_t limit = most < INT32_MAX ? (int32_t)most : INT32_MAX;

        *axis[i] = test_range(seed, -limit, limit);
    }
    v.r = (uint8_t)test_range(seed, 0, 255);
    v.g = (uint8_t)test_range(seed, 0, 255);
    v.b = (uint8_t)test_range(seed, 0, 255);
    return v;
}

static void projection_gives_the_same_bits(void)
{
    uint32_t seed = 101;
    int32_t i, tried = 0;

    for (i = 0; i < TEST_COUNT(200000) && !test_failed(); i++) {
        struct etch_clip_vertex in = make_vertex(&seed, 31, i % 3 == 0 ? 4 : 40);
        struct etch_vertex a, b;
        struct etch_viewport v;

        CHECK_EQ(etch_viewport_init(&v, rects[i % 4]), ETCH_OK);
        if (i % 7 == 0)
            in.z = i % 2 ? in.w : -in.w;
        if (etch_viewport_outcode(&v, &in) & ETCH_OUT_CLIP)
            continue;
        tried++;
        etch_viewport_project(&v, &in, &a);
        etch_viewport_project_small(&v, &in, &b);
        if (!CHECK(same_vertex(&a, &b))) {
            test_note("x", in.x);
            test_note("y", in.y);
            test_note("z", in.z);
            test_note("w", in.w);
        }
    }
    CHECK(tried > i / 8);
}

/* The vertex of the fast fan nearest to v, in 1/256 px on either axis. */
static int32_t distance_to_fast(const struct etch_vertex *v)
{
    int32_t best = INT32_MAX;
    int i, k;

    for (i = 0; i < fast.count; i++)
        for (k = 0; k < 3; k++) {
            const int32_t x = v->x_q8 - fast.v[i][k].x_q8, y = v->y_q8 - fast.v[i][k].y_q8;
            const int32_t dx = x < 0 ? -x : x, dy = y < 0 ? -y : y, d = dx > dy ? dx : dy;

            best = d < best ? d : best;
        }
    return best;
}

static bool is_near_screen(const struct etch_vertex *v)
{
    return v->x_q8 > -2048 * 256 && v->x_q8 < 2048 * 256 && v->y_q8 > -2048 * 256 &&
           v->y_q8 < 2048 * 256;
}

static void triangles_are_assembled(void)
{
    uint32_t seed = 102;
    int32_t i, clipped = 0;
    int k, n;

    for (i = 0; i < TEST_COUNT(60000) && !test_failed(); i++) {
        struct etch_assembly assembly = {.cull = (enum etch_cull)(i % 3), .flat = i % 5 == 4};
        const int kind = i % 4; /* mostly visible, .., mostly across planes */
        struct etch_clip_vertex v[3];
        uint8_t any = 0;

        CHECK_EQ(etch_viewport_init(&assembly.viewport, rects[0]), ETCH_OK);
        for (k = 0; k < 3; k++) {
            v[k] = make_vertex(&seed, 20, kind < 2 ? 4 : kind == 2 ? 8 : 64);
            if (kind == 3 && test_range(&seed, 0, 2) == 0)
                v[k].w = -v[k].w;
            any |= etch_viewport_outcode(&assembly.viewport, &v[k]);
        }
        fast.count = small.count = 0;
        fast.sink.triangle = small.sink.triangle = take;
        assembly.sink = &fast.sink;
        etch_assemble_triangle(&assembly, v);
        assembly.sink = &small.sink;
        etch_assemble_triangle_small(&assembly, v);
        if ((any & ETCH_OUT_CLIP) == 0) {
            compare_records();
            continue;
        }
        clipped++;
        for (n = 0; n < small.count; n++)
            for (k = 0; k < 3; k++) {
                const struct etch_vertex *const s = &small.v[n][k];

                CHECK(s->z_q16 <= UINT32_C(0xFFFF0000));
                CHECK(s->x_q8 >= -8388608 && s->x_q8 <= 8388608);
                CHECK(s->y_q8 >= -8388608 && s->y_q8 <= 8388608);
                if (is_near_screen(s) && fast.count != 0 && distance_to_fast(s) > 16)
                    CHECK_EQ(distance_to_fast(s), 0);
            }
    }
    CHECK(clipped > i / 8);
}

/* Two triangles that share an edge across the near plane get the same corner on it. */
static void a_cut_edge_stays_shared(void)
{
    uint32_t seed = 103;
    int32_t i;
    int k, j, shared;

    for (i = 0; i < TEST_COUNT(20000) && !test_failed(); i++) {
        struct etch_assembly assembly = {.cull = ETCH_CULL_NONE};
        struct etch_clip_vertex a[3], b[3];

        CHECK_EQ(etch_viewport_init(&assembly.viewport, rects[0]), ETCH_OK);
        for (k = 0; k < 3; k++) {
            a[k] = make_vertex(&seed, 18, 3);
            a[k].w += 65536;
        }
        a[1].z = -a[1].w - test_range(&seed, 1, 65536); /* before the near plane */
        b[0] = a[1], b[1] = a[0], b[2] = make_vertex(&seed, 18, 3);
        fast.count = small.count = 0;
        assembly.sink = &fast.sink;
        etch_assemble_triangle_small(&assembly, a);
        assembly.sink = &small.sink;
        etch_assemble_triangle_small(&assembly, b);
        if (fast.count < 2 || small.count < 2) /* a corner's triangles may have no area */
            continue;
        for (k = shared = 0; k < 3 * fast.count; k++)
            for (j = 0; j < 3 * small.count; j++)
                shared += fast.v[k / 3][k % 3].z_q16 < 65536 &&
                          same_vertex(&fast.v[k / 3][k % 3], &small.v[j / 3][j % 3]);
        CHECK(shared != 0);
    }
}

static void lights_and_rotations_keep_their_error(void)
{
    uint32_t seed = 104;
    int32_t i, r, c;

    for (i = 0; i < TEST_COUNT(65536) && !test_failed(); i++) {
        const uint16_t angle = (uint16_t)(i * TEST_DIVISOR);
        const struct etch_vector towards = {(int32_t)test_random(&seed) >> (3 + i % 12),
                                            (int32_t)test_random(&seed) >> (3 + i % 12),
                                            (int32_t)test_random(&seed) >> (3 + i % 12)};
        struct etch_light exact = {0, 0, 0, {0, 0, 0}}, light = exact;
        struct etch_matrix m, n;

        etch_matrix_rotate_y(&m, angle);
        etch_matrix_rotate_y_small(&n, angle);
        for (r = 0; r < 4; r++)
            for (c = 0; c < 4; c++) {
                const int32_t error = n.m[r][c] - m.m[r][c];

                CHECK(error >= -32 && error <= 32 && (angle % 16384 != 0 || error == 0));
            }
        CHECK_EQ(etch_light_aim(&exact, &m, &towards), ETCH_OK);
        CHECK_EQ(etch_light_aim_small(&light, &m, &towards), ETCH_OK);
        CHECK(light.x - exact.x <= 4 && light.x - exact.x >= -4);
        CHECK(light.y - exact.y <= 4 && light.y - exact.y >= -4);
        CHECK(light.z - exact.z <= 4 && light.z - exact.z >= -4);
    }
}

static void meshes_are_drawn(void)
{
    static int16_t position[8 * 3];
    static int8_t normal[8 * 3];
    static uint8_t color[8 * 3];
    static uint16_t index_of[20 * 3];
    const struct etch_mesh mesh = {position, normal, color, index_of, 8, 20, 32768, 13};
    const struct etch_light sun = {9000, -9000, 10000, {200, 100, 50}};
    const struct etch_lighting lighting = {{20, 30, 40}, 1, &sun};
    uint32_t seed = 105;
    int32_t i;
    int k;

    for (i = 0; i < TEST_COUNT(5000) && !test_failed(); i++) {
        struct etch_assembly assembly = {.cull = (enum etch_cull)(i % 3)};
        struct etch_mesh_stage a, b;
        struct etch_mesh_vertex buffer[8];
        struct etch_matrix clip;

        for (k = 0; k < 8 * 3; k++) {
            position[k] = (int16_t)test_range(&seed, -32768, 32767);
            normal[k] = (int8_t)test_range(&seed, -127, 127);
            color[k] = (uint8_t)test_range(&seed, 0, 255);
        }
        for (k = 0; k < 20 * 3; k++)
            index_of[k] = (uint16_t)test_range(&seed, 0, k % 9 ? 7 : 9);
        CHECK_EQ(etch_viewport_init(&assembly.viewport, rects[0]), ETCH_OK);
        etch_matrix_translate(&clip, 0, 0, 0);
        clip.m[3][3] = 6 * ETCH_Q16_ONE; /* all within w */
        clip.m[2][0] = test_range(&seed, -30000, 30000);
        etch_mesh_stage_init(&a, &mesh, &clip, etch_vertex_lit, &lighting);
        etch_mesh_stage_init_small(&b, &mesh, &clip, etch_vertex_lit_small, &lighting);
        a.color[1] = b.color[1] = 99;
        fast.count = small.count = 0;
        fast.sink.triangle = small.sink.triangle = take;
        assembly.sink = &fast.sink;
        CHECK_EQ(etch_mesh_draw(&a, &assembly, buffer, 8), ETCH_OK);
        assembly.sink = &small.sink;
        etch_mesh_draw_small(&b, &assembly);
        compare_records();
    }
}

void suite_mesh_small(void)
{
    RUN(projection_gives_the_same_bits);
    RUN(triangles_are_assembled);
    RUN(a_cut_edge_stays_shared);
    RUN(lights_and_rotations_keep_their_error);
    RUN(meshes_are_drawn);
}
