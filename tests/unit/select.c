/* tests/unit: feedback and selection. */
#include "core/draw/select.h"
#include "core/base/rgb565.h"
#include "core/draw/feedback.h"
#include "core/fragment/flat.h"
#include "core/fragment/gouraud.h"
#include "tests/harness/canvas.h"
#include "tests/unit/mesh_parts.h"

void suite_select(void);

#define TRIANGLES 12

static struct etch_vertex scene[TRIANGLES][3];

static void make_scene(uint32_t *seed)
{
    for (int i = 0; i < TRIANGLES * 3; i++) {
        struct etch_vertex *v = &scene[i / 3][i % 3];

        v->x_q8 = test_range(seed, -4000, 20000);
        v->y_q8 = test_range(seed, -4000, 16000);
        v->z_q16 = test_random(seed) >> (i % 2 * 4);
        v->r = (uint8_t)(i / 3 * 16 + 16); /* differs in RGB565 from triangle to triangle */
    }
}

static void draw(struct etch_sink *sink, int i)
{
    const struct etch_vertex *const v[3] = {&scene[i][0], &scene[i][1], &scene[i][2]};

    sink->triangle(sink, v);
}

/* Every pixel of a drawn scene has the colour of the triangle that selection finds there, with the
 * depth test and without. */
static void what_is_seen_is_selected(void)
{
    static uint16_t depth[48 * 64];
    static struct test_canvas canvas;
    etch_kernel *const kernels[2] = {etch_kernel_flat_less, etch_kernel_flat_lequal};
    uint32_t seed = 1;

    test_canvas_open_tight(&canvas, (struct etch_rect){0, 0, 64, 48});
    canvas.surface.depth = depth;
    for (int32_t n = 0; n < TEST_COUNT(20) && !test_failed(); n++) {
        struct etch_raster_sink raster;

        make_scene(&seed);
        test_canvas_wipe(&canvas);
        for (int i = 0; i < 48 * 64; i++)
            depth[i] = UINT16_MAX;
        etch_raster_sink_init(&raster, &canvas.surface, etch_triangle_flat_depth, kernels[n % 2]);
        for (int i = 0; i < TRIANGLES; i++)
            draw(&raster.sink, i);
        for (int16_t y = 0; y < 48; y++) {
            for (int16_t x = 0; x < 64; x++) {
                struct etch_select select;
                uint16_t expected = 0;

                CHECK_EQ(etch_select_init(&select, x, y, kernels[n % 2]), ETCH_OK);
                for (int i = 0; i < TRIANGLES; i++) {
                    select.names.name = (uint16_t)(i + 1);
                    draw(&select.names.sink, i);
                    if (test_canvas_drawn(&canvas, x, y) &&
                        test_canvas_at(&canvas, x, y) == etch_rgb565(scene[i][0].r, 0, 0))
                        expected = (uint16_t)(i + 1);
                }
                if (!CHECK_EQ(select.name, expected))
                    test_note("x", x), test_note("y", y);
                CHECK_EQ(select.depth, depth[y * 64 + x]);
            }
        }
    }
}

static void only_pixels_of_frames(void)
{
    struct etch_select select;

    CHECK_EQ(etch_select_init(&select, -1, 0, etch_kernel_flat_less), ETCH_EINVAL);
    CHECK_EQ(etch_select_init(&select, 0, -5, etch_kernel_flat_less), ETCH_EINVAL);
    CHECK_EQ(etch_select_init(&select, 32767, 0, etch_kernel_flat_less), ETCH_EINVAL);
    CHECK_EQ(etch_select_init(&select, 0, 32767, etch_kernel_flat_less), ETCH_EINVAL);
    CHECK_EQ(etch_select_init(&select, 32766, 32766, etch_kernel_flat_less), ETCH_OK);
    CHECK_EQ(select.name, 0);
}

static bool same_vertex(const struct etch_vertex *p, const struct etch_vertex *q)
{
    return p->x_q8 == q->x_q8 && p->y_q8 == q->y_q8 && p->z_q16 == q->z_q16 && p->r == q->r &&
           p->g == q->g && p->b == q->b && p->a == q->a;
}

/* Triangles, lines and points come back as they were handed on, and no more than there is room. */
static void feedback_keeps_what_comes(void)
{
    struct etch_feedback_primitive kept[4];
    struct etch_feedback f;
    const struct etch_vertex *const line[2] = {&scene[3][0], &scene[3][1]};
    uint32_t seed = 2;

    make_scene(&seed);
    kept[3].size = 77;
    etch_feedback_init(&f, kept, 3);
    draw(&f.sink, 0);
    f.sink.line(&f.sink, line);
    f.sink.point(&f.sink, &scene[4][0]);
    CHECK_EQ(etch_feedback_status(&f), ETCH_OK);
    CHECK_EQ(f.count, 3);
    CHECK(kept[0].size == 3 && kept[1].size == 2 && kept[2].size == 1);
    for (int i = 0; i < 3; i++)
        CHECK(same_vertex(&kept[0].v[i], &scene[0][i]));
    CHECK(same_vertex(&kept[1].v[0], line[0]) && same_vertex(&kept[1].v[1], line[1]));
    CHECK(same_vertex(&kept[2].v[0], &scene[4][0]));
    draw(&f.sink, 1);
    CHECK_EQ(etch_feedback_status(&f), ETCH_ENOMEM);
    CHECK_EQ(f.count, 4);
    CHECK_EQ(kept[3].size, 77);
    etch_feedback_init(&f, NULL, 0); /* only counts */
    draw(&f.sink, 0);
    CHECK_EQ(f.count, 1);
}

/* A mesh's feedback is what its sink would draw. */
static void feedback_of_a_mesh_draws_the_mesh(void)
{
    static const struct etch_vector centre = {0, 0, 0}, eye = {0, 100, 70000};
    static struct etch_feedback_primitive kept[64];
    static struct test_canvas direct, later;
    struct etch_feedback f;
    struct etch_raster_sink raster;
    struct etch_assembly assembly = assembly_for(&f.sink, screen);
    const struct etch_matrix m = camera(&eye, &centre, 8000, 40 * 65536);
    struct etch_mesh_stage stage;

    test_canvas_open(&direct, screen);
    test_canvas_open(&later, screen);
    etch_feedback_init(&f, kept, 64);
    etch_mesh_stage_init(&stage, &octahedron, &m, etch_vertex_plain, NULL);
    CHECK_EQ(etch_mesh_draw(&stage, &assembly, buffer, 6), ETCH_OK);
    CHECK_EQ(etch_feedback_status(&f), ETCH_OK);
    CHECK(f.count > 8); /* some are clipped: the eye is near */
    etch_raster_sink_init(&raster, &direct.surface, etch_triangle_gouraud, etch_kernel_gouraud);
    assembly.sink = &raster.sink;
    CHECK_EQ(etch_mesh_draw(&stage, &assembly, buffer, 6), ETCH_OK);
    for (uint32_t i = 0; i < f.count; i++) {
        const struct etch_vertex *const v[3] = {&kept[i].v[0], &kept[i].v[1], &kept[i].v[2]};

        CHECK_EQ(kept[i].size, 3);
        etch_triangle_gouraud(&later.surface, v, etch_kernel_gouraud);
    }
    CHECK_EQ(test_canvas_hash(&direct), test_canvas_hash(&later));
}

void suite_select(void)
{
    RUN(what_is_seen_is_selected);
    RUN(only_pixels_of_frames);
    RUN(feedback_keeps_what_comes);
    RUN(feedback_of_a_mesh_draws_the_mesh);
}
