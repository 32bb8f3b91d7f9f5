/* tests/unit: triangles and visible rows kept over the strips of a frame give the pixels of drawing
 * the frame at once, in the order they came, and say what found no room. */
#include "core/draw/mesh.h"
#include "core/draw/retained.h"
#include "core/draw/retained_rows.h"
#include "tests/harness/canvas.h"
#include "tests/harness/sample.h"

void suite_retained(void);

enum {
    MOST = 40,
    W = 60,
    H = 44
};

static struct test_canvas canvas;
static struct etch_vertex vertices[MOST][3];
static struct etch_retained_triangle kept[MOST];

/* Triangles of every kind round the frame; every fourth one in the plane of the one before. */
static void make(uint32_t *seed)
{
    const struct etch_rect frame = {0, 0, W, H};
    int i, k;

    for (i = 0; i < MOST; i++) {
        struct test_triangle t;

        test_triangle_make(
            &t, (enum test_triangle_kind)test_range(seed, 0, TEST_TRIANGLE_KINDS - 1), frame, seed);
        for (k = 0; k < 3; k++) {
            struct etch_vertex *const v = &vertices[i][k];

            v->x_q8 = t.x[k];
            v->y_q8 = t.y[k];
            v->z_q16 = test_random(seed) % UINT32_C(0xFFFF0000);
            v->r = (uint8_t)test_range(seed, 0, 255);
            v->g = (uint8_t)test_range(seed, 0, 255);
            v->b = (uint8_t)test_range(seed, 0, 255);
            v->a = 255;
            if (i % 4 == 3)
                v->z_q16 = vertices[i - 1][0].z_q16;
            if (i % 4 == 2)
                v->z_q16 = vertices[i][0].z_q16;
        }
    }
}

static void emit(struct etch_sink *sink)
{
    int i;

    for (i = 0; i < MOST; i++) {
        const struct etch_vertex *const v[3] = {&vertices[i][0], &vertices[i][1], &vertices[i][2]};

        sink->triangle(sink, v);
    }
}

/* Clips the canvas to each strip of `rows` in turn, bottom up every other time. */
static void strip_clip(struct etch_surface *s, int32_t i, int32_t rows, bool upwards)
{
    const int32_t strips = (H + rows - 1) / rows, y = (upwards ? strips - 1 - i : i) * rows;
    const struct etch_rect clip = {0, (int16_t)y, W, (int16_t)(y + rows < H ? y + rows : H)};

    s->clip = clip;
}

static void set_up_triangles_draw_every_strip(void)
{
    const struct etch_rect frame = {0, 0, W, H};
    uint32_t seed = 97;
    int32_t i, k;

    for (i = 0; i < TEST_COUNT(3000) && !test_failed(); i++) {
        const int32_t rows = test_range(&seed, 1, H);
        struct etch_raster_sink direct;
        struct etch_retained r;
        uint32_t hash;

        make(&seed);
        test_canvas_open(&canvas, frame);
        etch_raster_sink_init(&direct, &canvas.surface, etch_triangle_gouraud_depth,
                              etch_kernel_gouraud_lequal);
        emit(&direct.sink);
        hash = test_canvas_hash(&canvas);
        test_canvas_wipe(&canvas);
        etch_retained_init(&r, frame, etch_kernel_gouraud_lequal, kept, MOST);
        emit(&r.sink);
        CHECK_EQ(r.lost, 0);
        for (k = 0; k * rows < H; k++) {
            strip_clip(&canvas.surface, k, rows, i % 2 != 0);
            etch_retained_draw(&r, &canvas.surface);
        }
        canvas.surface.clip = frame;
        if (!CHECK_EQ(test_canvas_hash(&canvas), hash))
            test_note("rows", rows);
        CHECK_INSIDE(&canvas);
    }
}

/* With room for some, the first visible ones are drawn, and the others counted. */
static void what_finds_no_room_is_counted(void)
{
    const struct etch_rect frame = {0, 0, W, H};
    uint32_t seed = 98;
    int32_t i;

    for (i = 0; i < TEST_COUNT(500) && !test_failed(); i++) {
        const uint16_t room = (uint16_t)test_range(&seed, 0, MOST);
        const struct etch_retained_triangle guard = {.group_y0 = 4711};
        struct etch_retained all, some;
        uint16_t visible;

        make(&seed);
        etch_retained_init(&all, frame, etch_kernel_gouraud_lequal, kept, MOST);
        emit(&all.sink);
        visible = all.count;
        if (room < MOST)
            kept[room] = guard;
        etch_retained_init(&some, frame, etch_kernel_gouraud_lequal, kept, room);
        emit(&some.sink);
        CHECK_EQ(some.count, visible < room ? visible : room);
        CHECK_EQ(some.lost, visible - some.count);
        CHECK(room == MOST || kept[room].group_y0 == 4711);
    }
}

/* ---- a mesh, its visible triangles listed ------------------------------------------------------
 */

enum {
    NV = 24,
    NT = 50
};

static int16_t position[NV * 3];
static uint8_t color[NV * 3];
static uint16_t index_of[NT * 3];
static struct etch_mesh_vertex buffer[NV];
static struct etch_mesh_row_range list[NT];

static const struct etch_mesh mesh = {.positions = position,
                                      .colors = color,
                                      .indices = index_of,
                                      .vertex_count = NV,
                                      .triangle_count = NT,
                                      .extent = 32768,
                                      .bits = 14};

static void make_mesh(uint32_t *seed)
{
    int i;

    for (i = 0; i < NV * 3; i++) {
        position[i] = (int16_t)test_range(seed, -32768, 32767);
        color[i] = (uint8_t)test_range(seed, 0, 255);
    }
    for (i = 0; i < NT * 3; i++) /* a bad index now and then */
        index_of[i] = (uint16_t)test_range(seed, 0, test_range(seed, 0, 30) ? NV - 1 : NV + 2);
}

/* As several workers do it: vertices and triangles in ranges, in any order, a list for each range;
 * strip by strip the lists in the order of their triangles. */
static void ranges_give_the_same_lists(void)
{
    const struct etch_rect frame = {0, 0, W, H};
    uint32_t seed = 77;

    for (int32_t i = 0; i < TEST_COUNT(500) && !test_failed(); i++) {
        struct etch_assembly assembly = {.cull = (enum etch_cull)(i % 3)};
        static struct etch_mesh_vertex by_range[NV];
        struct etch_mesh_stage stage;
        struct etch_matrix clip;
        uint16_t visible, at = 0;
        const uint16_t v = (uint16_t)test_range(&seed, 0, NV);
        const uint16_t t = (uint16_t)test_range(&seed, 0, NT);

        make_mesh(&seed);
        CHECK_EQ(etch_viewport_init(&assembly.viewport, frame), ETCH_OK);
        CHECK_EQ(etch_matrix_perspective_focal(&clip, ETCH_Q16_ONE, ETCH_Q16_ONE, ETCH_Q16_ONE / 4,
                                               8 * ETCH_Q16_ONE),
                 ETCH_OK);
        clip.m[3][3] = ETCH_Q16_ONE;
        etch_mesh_stage_init(&stage, &mesh, &clip, etch_vertex_plain, NULL);
        etch_mesh_transform(&stage, &assembly.viewport, buffer);
        visible = etch_mesh_rows(&stage, &assembly, buffer, list, NT);
        etch_mesh_transform_range(&stage, &assembly.viewport, by_range, v, NV);
        etch_mesh_transform_range(&stage, &assembly.viewport, by_range, 0, v);
        for (int k = 0; k < 2; k++) {
            static struct etch_mesh_row_range part[NT];
            const uint16_t n = etch_mesh_rows_range(&stage, &assembly, by_range, part, NT,
                                                    k == 0 ? 0 : t, k == 0 ? t : NT);

            CHECK(at + n <= visible);
            for (uint16_t j = 0; j < n && !test_failed(); j++, at++) {
                CHECK_EQ(part[j].triangle, list[at].triangle);
                CHECK_EQ(part[j].y0, list[at].y0);
                CHECK_EQ(part[j].y1, list[at].y1);
                CHECK(part[j - j % ETCH_MESH_ROWS_GROUP].group_y0 <= part[j].y0);
                CHECK(part[j - j % ETCH_MESH_ROWS_GROUP].group_y1 >= part[j].y1);
            }
        }
        CHECK_EQ(at, visible);
    }
}

static void listed_triangles_draw_every_strip(void)
{
    const struct etch_rect frame = {0, 0, W, H};
    uint32_t seed = 99;
    int32_t i, k;

    for (i = 0; i < TEST_COUNT(2000) && !test_failed(); i++) {
        const int32_t rows = test_range(&seed, 1, H);
        struct etch_assembly assembly = {.cull = (enum etch_cull)(i % 3), .flat = i % 4 == 3};
        struct etch_raster_sink raster;
        struct etch_mesh_stage stage;
        struct etch_matrix clip;
        uint16_t visible;
        uint32_t hash;

        make_mesh(&seed);
        test_canvas_open(&canvas, frame);
        CHECK_EQ(etch_viewport_init(&assembly.viewport, frame), ETCH_OK);
        CHECK_EQ(etch_matrix_perspective_focal(&clip, ETCH_Q16_ONE, ETCH_Q16_ONE, ETCH_Q16_ONE / 4,
                                               8 * ETCH_Q16_ONE),
                 ETCH_OK);
        clip.m[3][3] = ETCH_Q16_ONE; /* the eye amid the mesh: some triangles are clipped */
        etch_mesh_stage_init(&stage, &mesh, &clip, etch_vertex_plain, NULL);
        etch_raster_sink_init(&raster, &canvas.surface, etch_triangle_gouraud_depth,
                              etch_kernel_gouraud_less);
        assembly.sink = &raster.sink;
        etch_mesh_transform(&stage, &assembly.viewport, buffer);
        etch_mesh_assemble(&stage, &assembly, buffer);
        hash = test_canvas_hash(&canvas);
        test_canvas_wipe(&canvas);
        visible = etch_mesh_rows(&stage, &assembly, buffer, list, NT);
        CHECK_EQ(etch_mesh_rows(&stage, &assembly, buffer, list, NT / 8 * 4), visible);
        CHECK_EQ(etch_mesh_rows(&stage, &assembly, buffer, list, NT), visible);
        for (k = 0; k * rows < H; k++) {
            strip_clip(&canvas.surface, k, rows, i % 2 != 0);
            etch_mesh_assemble_rows(&stage, &assembly, buffer, list, visible,
                                    canvas.surface.clip.y0, canvas.surface.clip.y1);
        }
        canvas.surface.clip = frame;
        if (!CHECK_EQ(test_canvas_hash(&canvas), hash))
            test_note("rows", rows);
        CHECK_INSIDE(&canvas);
    }
}

void suite_retained(void)
{
    RUN(set_up_triangles_draw_every_strip);
    RUN(what_finds_no_room_is_counted);
    RUN(listed_triangles_draw_every_strip);
    RUN(ranges_give_the_same_lists);
    test_print_count("", TEST_COUNT(3000) * MOST, " triangles kept over strips of every height");
}
