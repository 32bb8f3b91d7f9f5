/* tests/unit: lines as runs, against the definition of lines, and their varyings against exact
 * rationals. */
#include "core/draw/line.h"
#include "core/fragment/flat.h"
#include "core/fragment/gouraud.h"
#include "core/base/rgb565.h"
#include "core/raster/line_runs.h"
#include "tests/harness/canvas.h"
#include "tests/oracle/line.h"
#include "tests/unit/line_parts.h"

void suite_line_runs(void);

static struct test_canvas canvas;

static const struct etch_rect windows[] = {
    {0, 0, 48, 36}, {0, 0, 33, 25}, {150, 100, 190, 141}, {32727, 32731, 32767, 32767}};

static void open_window(uint32_t *seed, int32_t i)
{
    const struct etch_rect w = windows[i % 4];
    struct etch_rect clip = w;

    test_canvas_open(&canvas, w);
    if (i % 8 < 4)
        return;
    clip.x0 = (int16_t)test_range(seed, w.x0, w.x1 - 1);
    clip.y0 = (int16_t)test_range(seed, w.y0, w.y1 - 1);
    clip.x1 = (int16_t)test_range(seed, clip.x0, w.x1);
    clip.y1 = (int16_t)test_range(seed, clip.y0, w.y1);
    test_canvas_clip(&canvas, clip);
}

static void note_line(const int16_t p[4])
{
    test_note("x0", p[0]);
    test_note("y0", p[1]);
    test_note("x1", p[2]);
    test_note("y1", p[3]);
}

/* ---- pixels ---------------------------------------------------------------------------------- */

static void try_runs(const int16_t p[4])
{
    const struct etch_rect clip = canvas.surface.clip;
    struct test_run_log log;
    const struct test_run_paint paint = test_run_paint(&log, TEST_INK);
    int32_t x, y, wrong = 0;

    etch_line_runs(&canvas.surface, p[0], p[1], p[2], p[3], &paint.paint);
    for (y = clip.y0; y < clip.y1; y++)
        for (x = clip.x0; x < clip.x1; x++)
            wrong += oracle_line_covers(p[0], p[1], p[2], p[3], x, y) !=
                     test_canvas_drawn(&canvas, x, y);
    if (!CHECK_EQ(wrong, 0) || !CHECK(!log.broken))
        note_line(p);
    CHECK_INSIDE(&canvas);
}

static void runs_are_the_line(void)
{
    uint32_t seed = 1;
    int32_t i;

    for (i = 0; i < TEST_COUNT(40000) && !test_failed(); i++) {
        const struct etch_rect w = windows[i % 4];
        const int16_t p[4] = {
            pick(&seed, w.x0, w.x1, i % 3 == 0), pick(&seed, w.y0, w.y1, i % 3 == 0),
            pick(&seed, w.x0, w.x1, i % 3 == 0), pick(&seed, w.y0, w.y1, i % 3 == 0)};

        open_window(&seed, i);
        try_runs(p);
    }
    test_print_count("", i, " lines as runs, no differing pixel");
}

static void longest_lines(void)
{
    static const int16_t ends[] = {INT16_MIN, -1, 0, 17, INT16_MAX - 1, INT16_MAX};
    int i;

    for (i = 0; i < 6 * 6 * 6 * 6 && !test_failed(); i++) {
        const int16_t p[4] = {ends[i % 6], ends[i / 6 % 6], ends[i / 36 % 6], ends[i / 216]};

        test_canvas_open(&canvas, windows[i % 4]);
        try_runs(p);
    }
}

/* ---- varyings -------------------------------------------------------------------------------- */

struct sample {
    struct etch_vertex v[2];
    int32_t p[4];   /* the pixels */
    int64_t du;     /* of the major axis */
    int32_t u, low; /* which it is, and the coordinate of its smaller end */
    int first;      /* which vertex is there */
};

static void make_sample(struct sample *s, int32_t i, uint32_t *seed)
{
    const struct etch_rect w = windows[i % 4];
    int32_t size[2];
    int k;

    for (k = 0; k < 2; k++) {
        struct etch_vertex *v = &s->v[k];
        const uint32_t color = test_random(seed);

        v->x_q8 = pick(seed, w.x0, w.x1, i % 5 == 0) * 256 + test_range(seed, 0, 255);
        v->y_q8 = pick(seed, w.y0, w.y1, i % 5 == 0) * 256 + test_range(seed, 0, 255);
        v->z_q16 = i % 2 == 0 ? test_random(seed) : test_random(seed) & UINT32_C(0xFFFF0000);
        v->r = (uint8_t)color, v->g = (uint8_t)(color >> 8), v->b = (uint8_t)(color >> 16);
        v->a = 255;
        if (i % 11 == 0)
            v->r = (uint8_t)((color & 1) * 255), v->z_q16 = (color & 2) != 0 ? 0 : UINT32_MAX;
        s->p[2 * k] = v->x_q8 >> 8;
        s->p[2 * k + 1] = v->y_q8 >> 8;
    }
    for (k = 0; k < 2; k++)
        size[k] = s->p[2 + k] > s->p[k] ? s->p[2 + k] - s->p[k] : s->p[k] - s->p[2 + k];
    s->u = size[1] > size[0];
    s->du = size[s->u];
    s->first = s->p[2 + s->u] < s->p[s->u];
    s->low = s->p[2 * s->first + s->u];
}

/* |got unit - value| <= most in units of 1/64 step, where the value is `steps` / 255 steps a unit
 * of the channel, k pixels from the first of du. */
static bool is_channel(int32_t got, int32_t steps, int64_t a, int64_t b, int64_t k, int64_t du)
{
    const int64_t whole = 255 * du, value = (a * (du - k) + b * k) * steps;
    const int64_t error = 64 * (got * whole - value);

    return (error < 0 ? -error : error) <= 33 * whole;
}

static uint32_t clamped(uint32_t z)
{
    return z > UINT32_C(0xFFFF0000) ? UINT32_C(0xFFFF0000) : z;
}

/* Depth within 1/2 + k / 2^17. */
static bool is_depth(uint16_t got, int64_t a, int64_t b, int64_t k, int64_t du)
{
    const int64_t error = 2 * (got * (INT64_C(65536) * du) - (a * (du - k) + b * k));

    return (error < 0 ? -error : error) <= (65536 + k) * du;
}

static bool check_pixel(const struct sample *s, int32_t x, int32_t y, bool depth)
{
    const struct etch_vertex *a = &s->v[s->first], *b = &s->v[1 - s->first];
    const uint16_t got = test_canvas_at(&canvas, x, y);
    const uint16_t z =
        canvas.surface.depth[etch_surface_index(&canvas.surface, (int16_t)x, (int16_t)y)];
    const int64_t du = s->du == 0 ? 2 : s->du;
    const int64_t k = s->du == 0 ? 1 : (s->u != 0 ? y : x) - s->low;
    bool ok = CHECK(is_channel(got >> 11, 31, a->r, b->r, k, du)) &&
              CHECK(is_channel(got >> 5 & 63, 63, a->g, b->g, k, du)) &&
              CHECK(is_channel(got & 31, 31, a->b, b->b, k, du));

    if (s->du != 0 && (k == 0 || k == du)) {
        const struct etch_vertex *end = k == 0 ? a : b;

        ok = CHECK_EQ(got, etch_rgb565(end->r, end->g, end->b)) && ok;
        if (depth && (k == 0 || (a->z_q16 % 65536 == 0 && b->z_q16 % 65536 == 0)))
            ok = CHECK_EQ(z, (clamped(end->z_q16) + 0x8000) >> 16) && ok;
    }
    if (depth)
        ok = CHECK(is_depth(z, clamped(a->z_q16), clamped(b->z_q16), k, du)) && ok;
    return ok;
}

static void try_sample(const struct sample *s, etch_line_painter *painter, etch_kernel *kernel,
                       bool depth)
{
    const struct etch_vertex *const forth[2] = {&s->v[0], &s->v[1]};
    const struct etch_vertex *const back[2] = {&s->v[1], &s->v[0]};
    const struct etch_rect clip = canvas.surface.clip;
    uint32_t hash;
    int32_t x, y;

    painter(&canvas.surface, forth, kernel);
    for (y = clip.y0; y < clip.y1; y++)
        for (x = clip.x0; x < clip.x1; x++)
            if (oracle_line_covers(s->p[0], s->p[1], s->p[2], s->p[3], x, y) &&
                !check_pixel(s, x, y, depth)) {
                test_note("x", x);
                test_note("y", y);
            }
    CHECK_ONCE(&canvas);
    hash = test_canvas_hash(&canvas);
    test_canvas_wipe(&canvas);
    painter(&canvas.surface, back, kernel);
    CHECK_EQ(test_canvas_hash(&canvas), hash);
    painter(&canvas.surface, forth, kernel); /* once more changes nothing */
    CHECK_EQ(test_canvas_hash(&canvas), hash);
}

static void varyings_are_exact(void)
{
    uint32_t seed = 2;
    int32_t i;

    for (i = 0; i < TEST_COUNT(20000) && !test_failed(); i++) {
        struct sample s;

        make_sample(&s, i, &seed);
        open_window(&seed, i);
        if (i % 3 == 0)
            try_sample(&s, etch_line_gouraud, etch_kernel_gouraud, false);
        else
            try_sample(&s, etch_line_gouraud_depth, etch_kernel_gouraud_lequal, true);
        if (test_failed()) {
            test_note("x0", s.v[0].x_q8);
            test_note("y0", s.v[0].y_q8);
            test_note("x1", s.v[1].x_q8);
            test_note("y1", s.v[1].y_q8);
        }
    }
    test_print_count("", i, " coloured lines: each channel within 1/2 + 1/64 step, ends exact");
}

/* The plane itself, over lines as long as the plane: the ends of the longest, and no wrapping. */
static void planes_reach_both_ends(void)
{
    uint32_t seed = 3;
    int32_t i;

    for (i = 0; i < TEST_COUNT(100000) && !test_failed(); i++) {
        const int16_t p[4] = {pick(&seed, 0, 99, true), pick(&seed, 0, 99, true),
                              pick(&seed, 0, 99, true), pick(&seed, 0, 99, true)};
        const uint32_t whole[2] = {test_random(&seed) & 0xFFFF, test_random(&seed) & 0xFFFF};
        const uint32_t value[2] = {(i % 3 == 0 ? 65535 : whole[0]) * 65536 + 32768,
                                   (i % 5 == 0 ? 0 : whole[1]) * 65536 + 32768};
        struct etch_plane plane;

        etch_line_plane(&plane, p[0], p[1], p[2], p[3], value[0], value[1]);
        if (p[0] == p[2] && p[1] == p[3])
            continue;
        if (!CHECK_EQ(etch_plane_at(&plane, p[0], p[1]) >> 16, value[0] >> 16) ||
            !CHECK_EQ(etch_plane_at(&plane, p[2], p[3]) >> 16, value[1] >> 16))
            note_line(p);
    }
}

/* Of two lines that cross, the nearer one is seen, in either order; equal depth stays. */
static void depth_is_tested(void)
{
    const struct etch_vertex v[4] = {{128, 128, 0, 255, 0, 0, 255},
                                     {7 * 256, 128, UINT32_C(6) << 16, 255, 0, 0, 255},
                                     {3 * 256, 128, UINT32_C(3) << 16, 0, 0, 255, 255},
                                     {3 * 256, 700, UINT32_C(1) << 16, 0, 0, 255, 255}};
    const struct etch_vertex *const red[2] = {&v[0], &v[1]}, *const blue[2] = {&v[2], &v[3]};
    const struct etch_rect window = {0, 0, 8, 3};
    int order;

    test_canvas_open(&canvas, window);
    for (order = 0; order < 2; order++) {
        test_canvas_wipe(&canvas);
        etch_line_flat_depth(&canvas.surface, order == 0 ? red : blue, etch_kernel_flat_less);
        etch_line_gouraud_depth(&canvas.surface, order == 0 ? blue : red, etch_kernel_gouraud_less);
        CHECK_EQ(test_canvas_at(&canvas, 3, 0), order == 0 ? 0xF800 : 0x001F);
        CHECK_EQ(test_canvas_at(&canvas, 3, 2), 0x001F);
        CHECK_EQ(test_canvas_at(&canvas, 7, 0), 0xF800);
    }
    etch_line_flat_depth_swapped(&canvas.surface, red, etch_kernel_flat_lequal);
    CHECK_EQ(test_canvas_at(&canvas, 3, 0), 0x00F8);
}

void suite_line_runs(void)
{
    RUN(runs_are_the_line);
    RUN(longest_lines);
    RUN(varyings_are_exact);
    RUN(planes_reach_both_ends);
    RUN(depth_is_tested);
}
