/* tests/unit: lines and points through stages: those of the fused kernels bit for bit, alpha within
 * its bound of the exact value, clips change nothing. What whole pipelines make of them is proved
 * through scene files by tests/cli/fragments.c. */
#include "core/draw/line.h"
#include "core/draw/line_staged.h"
#include "core/fragment/gouraud.h"
#include "core/fragment/test.h"
#include "core/fragment/write.h"
#include "tests/harness/canvas.h"
#include "tests/oracle/line.h"
#include "tests/unit/line_parts.h"

void suite_line_staged(void);

static struct test_canvas canvas;

static etch_line_varying *const smooth_depth[] = {etch_line_varying_color, etch_line_varying_depth,
                                                  NULL};
static const struct etch_stage lequal[] = {
    {etch_source_depth, NULL}, {etch_stage_depth_lequal, NULL}, {etch_stage_depth_write, NULL},
    {etch_source_color, NULL}, {etch_stage_write, NULL},        {NULL, NULL}};
static const struct etch_line_pipeline as_fused = {smooth_depth, lequal, etch_kernel_staged};

static etch_varying *const smooth_triangles[] = {etch_varying_color, etch_varying_depth, NULL};
static const struct etch_pipeline triangles = {smooth_triangles, lequal, etch_kernel_staged};

static void make_ends(struct etch_vertex v[2], uint32_t *seed, int32_t i)
{
    for (int k = 0; k < 2; k++) {
        const uint32_t color = test_random(seed);

        v[k].x_q8 = pick(seed, 0, 40, i % 5 == 0) * 256 + test_range(seed, 0, 255);
        v[k].y_q8 = pick(seed, 0, 30, i % 5 == 0) * 256 + test_range(seed, 0, 255);
        v[k].z_q16 = i / 3 % 4 == 0 ? test_random(seed) % UINT32_C(0xFFFF0001)
                                    : UINT32_C(0x10000) * (uint32_t)test_range(seed, 20, 40);
        v[k].r = (uint8_t)color, v[k].g = (uint8_t)(color >> 8), v[k].b = (uint8_t)(color >> 16);
        v[k].a = (uint8_t)(i % 4 == 0 ? 255 * test_range(seed, 0, 1) : test_range(seed, 0, 255));
    }
}

static void note_ends(const struct etch_vertex v[2])
{
    test_note("x0", v[0].x_q8);
    test_note("y0", v[0].y_q8);
    test_note("x1", v[1].x_q8);
    test_note("y1", v[1].y_q8);
}

/* A window whose depths some pixels pass and some do not, drawn on within a random clip. */
static void open_canvas(uint32_t *seed)
{
    const struct etch_rect window = {0, 0, 40, 30};
    struct etch_rect clip = window;

    clip.x0 = (int16_t)test_range(seed, 0, 9);
    clip.y0 = (int16_t)test_range(seed, 0, 7);
    clip.x1 = (int16_t)test_range(seed, 20, 40);
    clip.y1 = (int16_t)test_range(seed, 15, 30);
    test_canvas_open(&canvas, window);
    test_canvas_clip(&canvas, clip);
}

static void prepare(void)
{
    const struct etch_rect c = canvas.surface.clip;

    test_canvas_wipe(&canvas);
    for (int16_t y = c.y0; y < c.y1; y++)
        for (int16_t x = c.x0; x < c.x1; x++)
            canvas.surface.depth[etch_surface_index(&canvas.surface, x, y)] =
                (uint16_t)(25 + (x * 7 + y * 3) % 11);
}

/* ---- the same as fused -------------------------------------------------------------------------
 */

static void draw_fused(int32_t kind, const struct etch_vertex *const v[2], uint16_t size)
{
    if (kind == 0)
        etch_line_gouraud_depth(&canvas.surface, v, etch_kernel_gouraud_lequal);
    else if (kind == 1)
        etch_line_wide(&canvas.surface, v, size, etch_triangle_gouraud_depth,
                       etch_kernel_gouraud_lequal);
    else
        etch_point_paint(&canvas.surface, v[0], size, etch_point_runs_round,
                         etch_kernel_gouraud_lequal);
}

static void draw_staged(int32_t kind, const struct etch_vertex *const v[2], uint16_t size)
{
    struct etch_staged_planes planes;

    if (kind == 0)
        etch_line_staged(&canvas.surface, v, &as_fused, &planes);
    else if (kind == 1)
        etch_line_wide_staged(&canvas.surface, v, size, &triangles, &planes);
    else
        etch_point_staged(&canvas.surface, v[0], size, etch_point_runs_round, &as_fused, &planes);
}

static void as_the_fused_kernels(void)
{
    uint32_t seed = 1;
    int32_t i, drawn = 0;

    for (i = 0; i < TEST_COUNT(20000) && !test_failed(); i++) {
        struct etch_vertex v[2];
        const struct etch_vertex *const ends[2] = {&v[0], &v[1]};
        const uint16_t size = (uint16_t)test_range(&seed, 0, 4000);
        uint32_t before, hash;

        make_ends(v, &seed, i);
        open_canvas(&seed);
        prepare();
        before = test_canvas_hash(&canvas);
        draw_fused(i % 3, ends, size);
        hash = test_canvas_hash(&canvas);
        drawn += hash != before;
        prepare();
        draw_staged(i % 3, ends, size);
        if (!CHECK_EQ(test_canvas_hash(&canvas), hash) || !CHECK_ONCE(&canvas))
            note_ends(v);
    }
    CHECK(drawn * 8 > i);
    test_print_count("", drawn,
                     " lines and points through stages, the pixels of the fused kernels");
}

/* ---- alpha and flat colours --------------------------------------------------------------------
 */

/* A stage that keeps what the chunk holds instead of drawing it. */
static uint16_t seen[4][40 * 30];

static void keep(struct etch_chunk *c, const void *data)
{
    (void)data;
    for (uint16_t i = 0; i < c->n; i++) {
        const int at = c->y * 40 + c->x + i;

        seen[0][at] = c->r[i], seen[1][at] = c->g[i];
        seen[2][at] = c->b[i], seen[3][at] = c->a[i];
    }
}

static etch_line_varying *const alpha_alone[] = {etch_line_varying_alpha, NULL};
static const struct etch_stage keep_alpha[] = {
    {etch_source_alpha, NULL}, {keep, NULL}, {NULL, NULL}};
static const struct etch_line_pipeline alphas = {alpha_alone, keep_alpha, etch_kernel_staged};

/* |seen - 256 value| <= 1, in 1/256: 1/512 + 1/512. */
static bool is_alpha(int32_t at, int64_t a, int64_t b, int64_t k, int64_t du)
{
    const int64_t error = seen[3][at] * du - 256 * (a * (du - k) + b * k);

    return (error < 0 ? -error : error) <= du;
}

static void alpha_within_its_bound(void)
{
    uint32_t seed = 2;
    int32_t i, drawn = 0;

    for (i = 0; i < TEST_COUNT(5000) && !test_failed(); i++) {
        struct etch_vertex v[2];
        const struct etch_vertex *const ends[2] = {&v[0], &v[1]};
        struct etch_staged_planes planes;

        make_ends(v, &seed, i);
        open_canvas(&seed);
        etch_line_staged(&canvas.surface, ends, &alphas, &planes);

        const int32_t p[4] = {v[0].x_q8 >> 8, v[0].y_q8 >> 8, v[1].x_q8 >> 8, v[1].y_q8 >> 8};
        const int32_t dx = p[2] > p[0] ? p[2] - p[0] : p[0] - p[2];
        const int32_t dy = p[3] > p[1] ? p[3] - p[1] : p[1] - p[3];
        const struct etch_rect c = canvas.surface.clip;

        for (int32_t at = 0; at < 40 * 30 && !test_failed(); at++) {
            const int32_t x = at % 40, y = at / 40, k = dy > dx ? y - p[1] : x - p[0];

            if (x < c.x0 || x >= c.x1 || y < c.y0 || y >= c.y1 ||
                !oracle_line_covers(p[0], p[1], p[2], p[3], x, y))
                continue;
            drawn++;
            if (dx == 0 && dy == 0
                    ? !CHECK(is_alpha(at, v[0].a, v[1].a, 1, 2))
                    : !CHECK(is_alpha(at, v[0].a, v[1].a, k < 0 ? -k : k, dy > dx ? dy : dx)))
                note_ends(v);
        }
    }
    CHECK(drawn > i);
    test_print_count("", drawn, " alphas along lines within 1/512 + 1/512");
}

static etch_line_varying *const flat_alone[] = {etch_line_varying_flat, NULL};
static const struct etch_stage keep_flat[] = {{etch_source_flat, NULL}, {keep, NULL}, {NULL, NULL}};
static const struct etch_line_pipeline flats = {flat_alone, keep_flat, etch_kernel_staged};

static void flat_is_vertex_0(void)
{
    const struct etch_vertex v[2] = {{128, 128, 0, 255, 255, 0, 77}, {900, 640, 9, 1, 2, 3, 4}};
    const struct etch_vertex *const ends[2] = {&v[0], &v[1]};
    const struct etch_rect window = {0, 0, 40, 30};
    struct etch_staged_planes planes;

    test_canvas_open(&canvas, window);
    etch_line_staged(&canvas.surface, ends, &flats, &planes);
    for (int k = 0; k < 4; k++) {
        const int32_t at = (k * 2 + 1) / 3 * 40 + k;

        CHECK_EQ(seen[0][at], 31 << 11);
        CHECK_EQ(seen[1][at], 63 << 10);
        CHECK_EQ(seen[2][at], 0);
        CHECK_EQ(seen[3][at], 77 * 256);
    }
}

void suite_line_staged(void)
{
    RUN(as_the_fused_kernels);
    RUN(alpha_within_its_bound);
    RUN(flat_is_vertex_0);
}
