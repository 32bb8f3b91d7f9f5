/* tests/unit: the pixels that meshes cover after clipping and culling, each once. */
#include "core/raster/triangle.h"
#include "tests/harness/canvas.h"
#include "tests/unit/mesh_parts.h"

void suite_mesh_pixels(void);

static struct test_canvas canvas;

/* Adds 1 to each pixel. */
static void count_pixels(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    const struct etch_point_q8 p[3] = {
        {v[0]->x_q8, v[0]->y_q8}, {v[1]->x_q8, v[1]->y_q8}, {v[2]->x_q8, v[2]->y_q8}};
    struct etch_triangle t;
    struct test_run_log log;
    struct test_run_paint paint = test_run_paint(&log, 1);

    (void)sink;
    paint.count = true;
    if (etch_triangle_setup(&t, p))
        etch_triangle_runs(&canvas.surface, &t, &paint.paint);
}

/* The eye stands on a floor that reaches behind it and past every guard plane: every pixel that
 * sees the floor is drawn once, whatever the triangles are. The floor ends beyond the far plane
 * (its edge is a straight line on the screen); rows clear of that line by 1/16 px must be full
 * or empty. */
static void floor_covers_each_pixel_once(void)
{
    uint32_t seed = 1;
    int32_t n, drawn = 0;

    test_canvas_open(&canvas, screen);
    for (n = 0; n < TEST_COUNT(400) && !test_failed(); n++) {
        struct etch_sink sink = {.triangle = count_pixels};
        const struct etch_assembly assembly = assembly_for(&sink, screen);
        const etch_q16 height = 1 + (int32_t)(test_random(&seed) >> test_range(&seed, 12, 24));
        const etch_q16 near = 1 + (height >> test_range(&seed, 1, 5));
        const struct etch_vector eye = {test_range(&seed, -65536, 65536), height,
                                        test_range(&seed, -65536, 65536)};
        const struct etch_vector level = {eye.x + test_range(&seed, -65536, 65536), height,
                                          eye.z + 65536};
        const etch_q16 far = 200 * 65536;
        const struct etch_matrix m = camera(&eye, &level, near, far);
        struct etch_mesh_stage stage;
        int32_t x, y, wrong = 0;

        make_grid(32767, &seed);
        etch_mesh_stage_init(&stage, &grid, &m, etch_vertex_plain, NULL);
        test_canvas_wipe(&canvas);
        CHECK_EQ(etch_mesh_draw(&stage, &assembly, buffer, GRID * GRID), ETCH_OK);
        for (y = 0; y < 48; y++) {
            /* the row's lower edge sees the floor at `depth` = height * focal / (y - 24): the
             * floor is there if near < depth < far. focal in px = 24 * m11. */
            const int64_t focal = (int64_t)m.m[1][1] * 24;
            const int64_t below = 2 * y + 1 - 48; /* half px under the horizon */
            const bool full = below > 0 && 2 * focal * height / 65536 * 17 / 16 < far * below &&
                              2 * focal * height / 65536 * 15 / 16 > near * below;
            const bool empty = below <= 0 || 2 * focal * height / 65536 * 15 / 16 > far * below ||
                               2 * focal * height / 65536 * 17 / 16 < near * below;

            for (x = 0; x < 64; x++) {
                const int32_t times = test_canvas_at(&canvas, x, y) - TEST_BACKGROUND;

                wrong += times > 1 || (full && times != 1) || (empty && times != 0);
                drawn += times;
            }
        }
        CHECK_INSIDE(&canvas);
        if (!CHECK_EQ(wrong, 0)) {
            test_note("height", height);
            test_note("near", near);
        }
    }
    test_print_count("", drawn, " pixels of floors through the eye, each drawn once");
}

/* A closed convex body: the faces that are kept cover the outline once, those culled cover the
 * same again, however close the eye is. */
static void front_and_back_cover_the_same(void)
{
    uint32_t seed = 2;
    int32_t n, drawn = 0;

    test_canvas_open(&canvas, screen);
    for (n = 0; n < TEST_COUNT(2000) && !test_failed(); n++) {
        static const struct etch_vector centre = {0, 0, 0};
        struct etch_sink sink = {.triangle = count_pixels};
        struct etch_assembly assembly = assembly_for(&sink, screen);
        const struct etch_vector eye = {test_range(&seed, -200000, 200000),
                                        test_range(&seed, -200000, 200000), 90000};
        const struct etch_matrix m = camera(&eye, &centre, 655, 40 * 65536);
        struct etch_mesh_stage stage;
        int32_t x, y, wrong = 0;

        etch_mesh_stage_init(&stage, &octahedron, &m, etch_vertex_plain, NULL);
        test_canvas_wipe(&canvas);
        assembly.cull = n % 2 == 0 ? ETCH_CULL_CLOCKWISE : ETCH_CULL_NONE;
        CHECK_EQ(etch_mesh_draw(&stage, &assembly, buffer, 6), ETCH_OK);
        for (y = 0; y < 48; y++) {
            for (x = 0; x < 64; x++) {
                const int32_t times = test_canvas_at(&canvas, x, y) - TEST_BACKGROUND;

                wrong += times != 0 && times != (n % 2 == 0 ? 1 : 2);
                drawn += times;
            }
        }
        if (!CHECK_EQ(wrong, 0)) {
            test_note("x", eye.x);
            test_note("y", eye.y);
        }
    }
    CHECK(drawn > n * 100);
}

void suite_mesh_pixels(void)
{
    RUN(floor_covers_each_pixel_once);
    RUN(front_and_back_cover_the_same);
}
