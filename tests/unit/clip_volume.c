/* tests/unit: the six-plane clip against the exact one of clip.h, and its pixels against those that
 * the scissor leaves. */
#include "core/raster/triangle.h"
#include "core/vertex/clip_volume.h"
#include "tests/harness/canvas.h"
#include "tests/oracle/wide.h"
#include "tests/unit/clip_parts.h"

void suite_clip_volume(void);

static struct test_canvas one, two;

/* ---- input ----------------------------------------------------------------------------------- */

static void note_triangle(const struct etch_clip_vertex v[3])
{
    int i;

    for (i = 0; i < 3; i++) {
        test_note("x", v[i].x);
        test_note("y", v[i].y);
        test_note("z", v[i].z);
        test_note("w", v[i].w);
    }
}

/* ---- corners --------------------------------------------------------------------------------- */

/* b is a, beginning elsewhere. */
static bool is_turned(const struct etch_clip_vertex *a, const struct etch_clip_vertex *b, int n)
{
    int turn, i;

    for (turn = 0; turn < n; turn++) {
        for (i = 0; i < n && same_vertex(&a[i], &b[(i + turn) % n]); i++)
            ;
        if (i == n)
            return true;
    }
    return n == 0;
}

/* The pipeline gives the polygon that etch_clip_triangle gives with guard planes at the sides,
 * whose corners tests/unit/clip.c proves; every input. */
static void corners_are_exact(void)
{
    uint32_t seed = 1;
    int32_t n, kept = 0;

    for (n = 0; n < TEST_COUNT(100000) && !test_failed(); n++) {
        const struct etch_viewport sides = {{0, 0, 100, 100}, 0, 0};
        struct etch_clip_vertex v[3], a[ETCH_CLIP_MAX], b[ETCH_CLIP_MAX];
        int i, count;

        for (i = 0; i < 3; i++)
            random_vertex(&v[i], test_range(&seed, 0, 9) == 0 ? 4 : n % 5, &seed);
        count = etch_clip_triangle(&sides, v, a);
        if (!CHECK_EQ(etch_clip_triangle_volume(v, b), count) || !CHECK(is_turned(a, b, count)))
            note_triangle(v);
        kept += count != 0;
    }
    CHECK(kept > TEST_COUNT(20000));
    test_print_count("", kept, " clipped triangles, equal bit for bit to the other clipper's");
}

/* ---- pixels ---------------------------------------------------------------------------------- */

/* Adds 1 to every pixel of a triangle. */
struct counting {
    struct etch_sink sink;
    const struct etch_surface *surface;
    struct test_run_log log;
};

static void count(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    struct counting *c = (struct counting *)(void *)sink;
    const struct etch_point_q8 p[3] = {
        {v[0]->x_q8, v[0]->y_q8}, {v[1]->x_q8, v[1]->y_q8}, {v[2]->x_q8, v[2]->y_q8}};
    struct test_run_paint paint = test_run_paint(&c->log, 1);
    struct etch_triangle t;

    paint.count = true;
    if (etch_triangle_setup(&t, p))
        etch_triangle_runs(c->surface, &t, &paint.paint);
}

typedef void assemble(const struct etch_assembly *assembly, const struct etch_clip_vertex v[3]);

static void draw(struct test_canvas *canvas, const struct etch_viewport *viewport,
                 const struct etch_clip_vertex v[3], assemble *take)
{
    struct counting counting = {.sink = {count, NULL, NULL}, .surface = &canvas->surface};
    struct etch_assembly assembly = {.viewport = *viewport, .cull = ETCH_CULL_NONE};

    assembly.sink = &counting.sink;
    take(&assembly, v);
}

static int32_t times(const struct test_canvas *c, int32_t x, int32_t y)
{
    return test_canvas_at(c, x, y) - TEST_BACKGROUND;
}

/* Whether the centre of pixel (x, y) is within 2^bits / 256 px of the line a b:
 * side^2 <= 4^bits length^2. */
static bool is_near(const struct etch_vertex *a, const struct etch_vertex *b, int32_t x, int32_t y,
                    int bits)
{
    const int64_t dx = b->x_q8 - a->x_q8, dy = b->y_q8 - a->y_q8;
    const int64_t side = dx * (256 * y + 128 - a->y_q8) - dy * (256 * x + 128 - a->x_q8);
    const uint64_t size = (uint64_t)(side < 0 ? -side : side) >> bits;

    return wide_at_most(wide_product(size, size), wide_product((uint64_t)(dx * dx + dy * dy), 1));
}

/* A triangle round the volume, in front of the eye; kind 1 crosses near or far. */
static void random_triangle(struct etch_clip_vertex v[3], int kind, uint32_t *seed)
{
    int i;

    for (i = 0; i < 3; i++) {
        random_vertex(&v[i], 3, seed);
        v[i].w = test_range(seed, 1000, INT32_C(1) << 17);
        v[i].x = test_range(seed, -2 * v[i].w, 2 * v[i].w);
        v[i].y = test_range(seed, -2 * v[i].w, 2 * v[i].w);
        v[i].z = test_range(seed, -v[i].w, v[i].w);
        if (kind != 0 && test_range(seed, 0, 1) == 0)
            v[i].z = 2 * v[i].z;
        if (kind != 0 && test_range(seed, 0, 3) == 0)
            v[i].w = -v[i].w / 2;
    }
}

static const struct etch_rect views[] = {
    {0, 0, 48, 36}, {5, 7, 40, 30}, {0, 0, 33, 25}, {3, 3, 4, 4}};

/* Pixels that differ lie near an edge of what the default clipper leaves; `bits` as in is_near. */
static int32_t compare(const struct etch_viewport *viewport, const struct etch_clip_vertex v[3],
                       int bits)
{
    struct etch_clip_vertex polygon[ETCH_CLIP_MAX];
    struct etch_vertex p[ETCH_CLIP_MAX];
    const int n = etch_clip_triangle(viewport, v, polygon);
    int32_t x, y, differ = 0;
    int i;

    for (i = 0; i < n; i++)
        etch_viewport_project(viewport, &polygon[i], &p[i]);
    for (y = 0; y < 36; y++) {
        for (x = 0; x < 48; x++) {
            const struct etch_rect r = viewport->rect;
            const bool inside = x >= r.x0 && x < r.x1 && y >= r.y0 && y < r.y1;

            CHECK(times(&two, x, y) <= (inside ? 1 : 0));
            if (!inside || times(&one, x, y) == times(&two, x, y))
                continue;
            differ++;
            for (i = 0; i < n && !is_near(&p[i], &p[(i + 1) % n], x, y, bits); i++)
                ;
            if (!CHECK(i < n)) {
                test_note("px", x);
                test_note("py", y);
            }
        }
    }
    return differ;
}

static void pixels(int kind, int bits, uint32_t seed)
{
    const struct etch_rect window = {0, 0, 48, 36};
    int32_t n, differ = 0;

    test_canvas_open(&one, window);
    test_canvas_open(&two, window);
    for (n = 0; n < TEST_COUNT(4000) && !test_failed(); n++) {
        struct etch_viewport viewport;
        struct etch_clip_vertex v[3];

        (void)etch_viewport_init(&viewport, views[n % 4]);
        random_triangle(v, kind, &seed);
        test_canvas_wipe(&one);
        test_canvas_wipe(&two);
        draw(&one, &viewport, v, etch_assemble_triangle);
        draw(&two, &viewport, v, etch_assemble_triangle_volume);
        differ += compare(&viewport, v, bits);
        if (test_failed())
            note_triangle(v);
    }
    test_print_count("", differ, " pixels differ from the scissor's, each of them on an edge");
}

static void pixels_are_the_scissors(void)
{
    pixels(0, 1, 2);
}

static void and_across_near_and_far(void)
{
    pixels(1, 2, 3);
}

/* Four triangles round a vertex: what differs from the default lies at the outer edges, so there
 * is no gap along those that are shared, and no pixel is drawn twice. */
static void meshes_stay_watertight(void)
{
    const struct etch_rect window = {0, 0, 48, 36};
    uint32_t seed = 4;
    int32_t n, x, y;

    test_canvas_open(&one, window);
    for (n = 0; n < TEST_COUNT(2000) && !test_failed(); n++) {
        struct etch_viewport viewport;
        struct etch_clip_vertex v[5];
        struct etch_vertex p[5];
        int i;

        (void)etch_viewport_init(&viewport, views[n % 4]);
        test_canvas_wipe(&one);
        for (i = 0; i < 5; i++) {
            const int32_t side = i < 4 ? 3 : 1;

            random_vertex(&v[i], 3, &seed);
            v[i].w = test_range(&seed, 1000, INT32_C(1) << 17);
            v[i].z = 0;
            v[i].x = test_range(&seed, side == 3 ? v[i].w : -v[i].w, side * v[i].w);
            v[i].y = test_range(&seed, side == 3 ? v[i].w : -v[i].w, side * v[i].w);
            v[i].x = i == 1 || i == 2 ? -v[i].x : v[i].x;
            v[i].y = i == 2 || i == 3 ? -v[i].y : v[i].y;
            etch_viewport_project(&viewport, &v[i], &p[i]);
        }
        for (i = 0; i < 4; i++) {
            const struct etch_clip_vertex t[3] = {v[i], v[(i + 1) % 4], v[4]};

            draw(&one, &viewport, t, etch_assemble_triangle_volume);
        }
        for (y = viewport.rect.y0; y < viewport.rect.y1; y++)
            for (x = viewport.rect.x0; x < viewport.rect.x1; x++)
                if (!CHECK_EQ(times(&one, x, y), 1))
                    note_triangle(v);
    }
    test_print_count("", n, " viewports covered by four clipped triangles, each pixel once");
}

/* What is left of a plane z / w = (a x + b y + 1024 c) / 2^14 between near and far, x and y in
 * 1/1024 of w; the viewport is 48 x 36. +1: pixel (px, py) must be drawn, -1: it must not, 0: it is
 * within 1/16 px of a cut. All times 48 * 36. */
static int expected(int32_t a, int32_t b, int32_t c, int32_t px, int32_t py)
{
    const int64_t x = (2 * px + 1 - 48) * 1024, y = (36 - 2 * py - 1) * 1024;
    const int64_t value = a * x * 36 + b * y * 48 + INT64_C(1024) * 1728 * c;
    const int64_t limit = INT64_C(16) * 1024 * 1728;
    const int64_t margin = 128 * ((a < 0 ? -a : a) * 36 + (b < 0 ? -b : b) * 48);
    const int64_t size = value < 0 ? -value : value;

    return size + margin < limit ? 1 : size - margin > limit ? -1 : 0;
}

/* Four triangles in one plane round the viewport, cut by near and far, with any w: each pixel of
 * what is left is drawn once, by both clippers, and the cuts are where they must be. */
static void near_and_far_cut_where_they_must(void)
{
    const struct etch_viewport viewport = {{0, 0, 48, 36}, 5, 5};
    uint32_t seed = 5;
    int32_t n, x, y, cut = 0;

    test_canvas_open(&one, viewport.rect);
    for (n = 0; n < TEST_COUNT(3000) && !test_failed(); n++) {
        const int32_t a = test_range(&seed, -24, 24), b = test_range(&seed, -24, 24);
        const int32_t c = test_range(&seed, -20, 20);
        struct etch_clip_vertex v[5];
        int i;

        test_canvas_wipe(&one);
        for (i = 0; i < 5; i++) {
            const int32_t lo = i < 4 ? 1024 : -900, hi = i < 4 ? 3000 : 900;
            const int32_t right = i == 1 || i == 2 ? -1 : 1, up = i == 2 || i == 3 ? -1 : 1;
            const int32_t vx = right * test_range(&seed, lo, hi);
            const int32_t vy = up * test_range(&seed, lo, hi);
            const int32_t unit = test_range(&seed, 1, 40); /* w = 2^14 unit */

            random_vertex(&v[i], 3, &seed);
            v[i].w = unit * 16384;
            v[i].x = unit * 16 * vx;
            v[i].y = unit * 16 * vy;
            v[i].z = unit * (a * vx + b * vy + 1024 * c);
        }
        for (i = 0; i < 4; i++) {
            const struct etch_clip_vertex t[3] = {v[i], v[(i + 1) % 4], v[4]};

            draw(&one, &viewport, t,
                 n % 2 == 0 ? etch_assemble_triangle : etch_assemble_triangle_volume);
        }
        for (y = 0; y < 36; y++) {
            for (x = 0; x < 48; x++) {
                const int must = expected(a, b, c, x, y);

                cut += must <= 0;
                if (!CHECK(times(&one, x, y) <= 1) ||
                    !CHECK(must == 0 || times(&one, x, y) == (must > 0))) {
                    test_note("px", x);
                    test_note("py", y);
                    note_triangle(v);
                }
            }
        }
    }
    test_print_count("", cut, " pixels cut off by near and far, none off by more than 1/16 px");
}

void suite_clip_volume(void)
{
    RUN(corners_are_exact);
    RUN(pixels_are_the_scissors);
    RUN(and_across_near_and_far);
    RUN(meshes_stay_watertight);
    RUN(near_and_far_cut_where_they_must);
}
