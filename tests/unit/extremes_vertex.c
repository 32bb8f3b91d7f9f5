/* tests/unit: clip space at the extremes: w of one ulp, w from 1 to 65,535, vertices on and behind
 * the near plane, at w = 0; matrices multiplied a thousand times; a view straight up.
 * tests/EXTREMES.md lists what is where. */
#include "core/vertex/assembly.h"
#include "core/vertex/matrix.h"
#include "tests/harness/harness.h"

void suite_extremes_vertex(void);

/* What came out. */
static struct {
    struct etch_sink sink;
    int n;
    struct etch_vertex v[16][3];
} out;

static void store(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    (void)sink;
    for (int i = 0; i < 3 && CHECK(out.n < 16); i++)
        out.v[out.n][i] = *v[i];
    out.n++;
}

/* Through a viewport of 64 x 48. */
static int assemble(const struct etch_clip_vertex v[3])
{
    struct etch_assembly a = {.cull = ETCH_CULL_NONE, .flat = false, .sink = &out.sink};

    out.sink.triangle = store;
    out.n = 0;
    CHECK_EQ(etch_viewport_init(&a.viewport, (struct etch_rect){0, 0, 64, 48}), ETCH_OK);
    etch_assemble_triangle(&a, v);
    return out.n;
}

/* w = 1/65536: the largest visible coordinates are 1/65536 too, and exact corners of the frame. */
static void w_of_one_ulp(void)
{
    static const struct etch_clip_vertex v[3] = {
        {-1, -1, -1, 1, 0, 0, 0, 0}, {1, -1, 1, 1, 0, 0, 0, 0}, {-1, 1, 0, 1, 0, 0, 0, 0}};

    CHECK_EQ(assemble(v), 1);
    CHECK(out.v[0][0].x_q8 == 0 && out.v[0][0].y_q8 == 48 * 256 && out.v[0][0].z_q16 == 0);
    CHECK(out.v[0][1].x_q8 == 64 * 256 && out.v[0][1].y_q8 == 48 * 256);
    CHECK_EQ(out.v[0][1].z_q16, UINT32_C(0xFFFF0000));
    CHECK(out.v[0][2].x_q8 == 0 && out.v[0][2].y_q8 == 0);
    CHECK_EQ(out.v[0][2].z_q16, UINT32_C(0x7FFF8000));
}

/* w of 1 and 65,535 ulp in one triangle: each vertex is projected by its own w, exactly. */
static void w_from_1_to_65535(void)
{
    static const struct etch_clip_vertex v[3] = {{0, 0, 0, 1, 0, 0, 0, 0},
                                                 {65535, 0, 65535, 65535, 0, 0, 0, 0},
                                                 {0, 13107, -65535, 65535, 0, 0, 0, 0}};

    CHECK_EQ(assemble(v), 1);
    CHECK(out.v[0][0].x_q8 == 32 * 256 && out.v[0][0].y_q8 == 24 * 256);
    CHECK(out.v[0][1].x_q8 == 64 * 256 && out.v[0][1].z_q16 == UINT32_C(0xFFFF0000));
    CHECK(out.v[0][2].z_q16 == 0); /* y = 24 (1 - 1/5) px = 19.2, to 1/256 */
    CHECK_EQ(out.v[0][2].y_q8, (24 * 256 * 4 * 2 + 5) / 10);
}

/* On the near plane, z = -w, is inside: nothing is cut. One ulp before it is cut, on the exact
 * edge. */
static void vertices_on_the_near_plane(void)
{
    struct etch_clip_vertex v[3] = {{-65536, 0, -65536, 65536, 0, 0, 0, 0},
                                    {65536, 0, -65536, 65536, 0, 0, 0, 0},
                                    {0, 65536, -65536, 65536, 0, 0, 0, 0}};

    CHECK_EQ(assemble(v), 1);
    for (int i = 0; i < 3; i++)
        CHECK_EQ(out.v[0][i].z_q16, 0);
    v[2].z--;
    CHECK(assemble(v) <= 1); /* only the edge of the other two is left: no area */
    v[0].z = v[1].z = v[2].z;
    CHECK_EQ(assemble(v), 0);
}

static void vertices_behind_the_eye(void)
{
    struct etch_clip_vertex v[3] = {{0, 0, -131072, -65536, 0, 0, 0, 0},
                                    {65536, 0, -131072, -1, 0, 0, 0, 0},
                                    {0, 65536, -131072, INT32_MIN, 0, 0, 0, 0}};

    CHECK_EQ(assemble(v), 0);
    v[0] = (struct etch_clip_vertex){0, 0, 0, 65536, 0, 0, 0, 0}; /* one in sight: a part is left */
    CHECK(assemble(v) >= 1);
    for (int t = 0; t < out.n; t++)
        for (int i = 0; i < 3; i++)
            CHECK(out.v[t][i].z_q16 <= UINT32_C(0xFFFF0000));
}

/* A vertex at w = 0, one of all zeros (the eye): it is cut away, and what is left is finite. */
static void a_vertex_at_w_0(void)
{
    struct etch_clip_vertex v[3] = {{0, 0, 0, 0, 0, 0, 0, 0},
                                    {65536, 0, 0, 65536, 0, 0, 0, 0},
                                    {0, 65536, 0, 65536, 0, 0, 0, 0}};

    CHECK(assemble(v) <= 2);
    v[0].x = 65536;
    v[0].z = -1;
    CHECK(assemble(v) >= 1);
    for (int t = 0; t < out.n; t++)
        for (int i = 0; i < 3; i++)
            CHECK(out.v[t][i].x_q8 >= -8388608 && out.v[t][i].x_q8 <= 8388608 &&
                  out.v[t][i].y_q8 >= -8388608 && out.v[t][i].y_q8 <= 8388608);
}

/* A thousand turns by 1/1000 of a turn or so: an entry drifts by less than a unit a product, in all
 * by less than 1000 / 65536; a thousand quarter turns, which are exact, by nothing. */
static void matrices_composed_a_thousand_times(void)
{
    struct etch_matrix all, turn, whole;

    etch_matrix_identity(&all);
    etch_matrix_rotate_z(&turn, 0x4000);
    for (int i = 0; i < 1000; i++)
        CHECK_EQ(etch_matrix_multiply(&all, &turn, &all), ETCH_OK);
    etch_matrix_identity(&whole);
    for (int i = 0; i < 16; i++)
        CHECK_EQ(all.m[i / 4][i % 4], whole.m[i / 4][i % 4]);
    etch_matrix_rotate_z(&turn, 66);
    for (int i = 0; i < 1000; i++)
        CHECK_EQ(etch_matrix_multiply(&all, &turn, &all), ETCH_OK);
    etch_matrix_rotate_z(&whole, (uint16_t)(66000 % 65536));
    for (int i = 0; i < 16; i++) {
        const int32_t off = all.m[i / 4][i % 4] - whole.m[i / 4][i % 4];

        CHECK(off > -1000 && off < 1000);
    }
}

/* Looking along the up vector is no view, up or down; with up along -z it is the exact one. */
static void looking_straight_up(void)
{
    static const struct etch_vector eye = {0, 0, 0}, above = {0, 65536, 0}, below = {0, -65536, 0};
    static const struct etch_vector up = {0, 65536, 0}, forward = {0, 0, -65536};
    struct etch_matrix m;

    CHECK_EQ(etch_matrix_look_at(&m, &eye, &above, &up), ETCH_EINVAL);
    CHECK_EQ(etch_matrix_look_at(&m, &eye, &below, &up), ETCH_EINVAL);
    CHECK_EQ(etch_matrix_look_at(&m, &eye, &above, &forward), ETCH_OK);
    CHECK(m.m[2][1] == -65536 && m.m[2][0] == 0 && m.m[2][2] == 0); /* back is down */
    CHECK(m.m[1][2] == -65536 && m.m[1][0] == 0 && m.m[1][1] == 0); /* up is forward */
}

/* near = 1/4, far = 65,535 times that: the entries are -65536 / 65534 and -1/2 65535 / 65534,
 * rounded. */
static void near_to_far_1_to_65535(void)
{
    struct etch_matrix m;

    CHECK_EQ(etch_matrix_perspective_focal(&m, 65536, 65536, 16384, 16384 * INT32_C(65535)),
             ETCH_OK);
    CHECK_EQ(m.m[2][2], -65538);
    CHECK_EQ(m.m[2][3], -32769);
    CHECK_EQ(m.m[3][2], -65536);
}

void suite_extremes_vertex(void)
{
    RUN(near_to_far_1_to_65535);
    RUN(w_of_one_ulp);
    RUN(w_from_1_to_65535);
    RUN(vertices_on_the_near_plane);
    RUN(vertices_behind_the_eye);
    RUN(a_vertex_at_w_0);
    RUN(matrices_composed_a_thousand_times);
    RUN(looking_straight_up);
}
