/* tests/unit: what clipped triangles cover: each pixel once along shared edges, near and far cut
 * where they must, the sides are the scissor's. */
#include "core/vertex/clip_volume.h"
#include "tests/oracle/triangle.h"
#include "tests/unit/clip_count.h"
#include "tests/unit/clip_parts.h"

void suite_clip_cover(void);

static struct test_canvas one;

static const struct etch_rect views[] = {
    {0, 0, 48, 36}, {5, 7, 40, 30}, {0, 0, 33, 25}, {3, 3, 4, 4}};

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

/* ---- sides ----------------------------------------------------------------------------------- */

/* A triangle between near and far that crosses any of the sides, as far as the guard planes let it.
 */
static bool make_sides(struct etch_clip_vertex v[3], const struct etch_viewport *viewport,
                       uint32_t *seed)
{
    const int32_t times_w = test_range(seed, 2, 600);
    uint8_t bits = 0;

    for (int i = 0; i < 3; i++) {
        random_vertex(&v[i], 3, seed);
        v[i].w = test_range(seed, 1000, INT32_C(1) << 17);
        v[i].x = test_range(seed, -times_w * v[i].w, times_w * v[i].w);
        v[i].y = test_range(seed, -times_w * v[i].w, times_w * v[i].w);
        if (test_range(seed, 0, 2) == 0)
            v[i].x /= times_w, v[i].y /= times_w;
        v[i].z = test_range(seed, -v[i].w, v[i].w);
        bits |= etch_viewport_outcode(viewport, &v[i]);
    }
    return (bits & ETCH_OUT_CLIP) == 0;
}

/* Side planes are left to the scissor: inside the viewport the pixels are those of the whole
 * projected triangle, by its definition, and none is outside. */
static void sides_are_the_scissor(void)
{
    const struct etch_rect window = {0, 0, 48, 36};
    uint32_t seed = 6;
    int32_t crossed = 0, drawn = 0;

    test_canvas_open(&one, window);
    for (int32_t n = 0; n < TEST_COUNT(4000) && !test_failed(); n++) {
        const struct etch_rect parts[] = {{0, 0, 48, 36}, {5, 7, 40, 30}, {3, 3, 4, 4}};
        struct etch_viewport viewport;
        struct etch_clip_vertex v[3];
        struct oracle_triangle t;
        int32_t xs[3], ys[3];

        (void)etch_viewport_init(&viewport, parts[n % 3]);
        if (!make_sides(v, &viewport, &seed))
            continue;
        for (int i = 0; i < 3; i++) {
            struct etch_vertex p;

            etch_viewport_project(&viewport, &v[i], &p);
            xs[i] = p.x_q8, ys[i] = p.y_q8;
        }
        oracle_triangle_make(&t, xs, ys);
        test_canvas_clip(&one, viewport.rect);
        draw(&one, &viewport, v, etch_assemble_triangle);
        crossed++;
        for (int32_t y = viewport.rect.y0; y < viewport.rect.y1; y++)
            for (int32_t x = viewport.rect.x0; x < viewport.rect.x1; x++) {
                const bool covered = oracle_triangle_covers(&t, x, y);

                drawn += covered;
                if (!CHECK_EQ(times(&one, x, y), covered)) {
                    test_note("px", x);
                    test_note("py", y);
                    note_triangle(v);
                }
            }
        CHECK_INSIDE(&one);
    }
    CHECK(crossed * 2 > TEST_COUNT(4000) && drawn > crossed);
    test_print_count("", crossed, " triangles across the sides, no differing pixel inside");
}

void suite_clip_cover(void)
{
    RUN(meshes_stay_watertight);
    RUN(near_and_far_cut_where_they_must);
    RUN(sides_are_the_scissor);
}
