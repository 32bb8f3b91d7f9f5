/* tests/unit: the six-plane clip against the exact one of clip.h, and its pixels against those that
 * the scissor leaves. */
#include "core/vertex/clip_volume.h"
#include "tests/oracle/wide.h"
#include "tests/unit/clip_count.h"
#include "tests/unit/clip_parts.h"

void suite_clip_volume(void);

static struct test_canvas one, two;

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

void suite_clip_volume(void)
{
    RUN(corners_are_exact);
    RUN(pixels_are_the_scissors);
    RUN(and_across_near_and_far);
}
