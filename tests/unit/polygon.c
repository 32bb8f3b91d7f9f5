/* tests/unit: polygons by scan lines against counted crossings, triangles and whole frames. */
#include "core/draw/polygon.h"
#include "tests/harness/bands.h"
#include "tests/harness/shapes.h"
#include "tests/harness/stores.h"
#include "tests/oracle/polygon.h"

void suite_polygon(void);

enum {
    POINTS = 40,
    LIMIT = 1 << 23
};

static struct test_canvas canvas, other;
static struct etch_polygon_edge edges[POINTS + 400];
static struct etch_polygon polygon;
static int32_t polygons;

/* A polygon and its edges as they were given. */
struct sample {
    struct etch_point_q8 v[POINTS];
    uint16_t size[4];
    uint16_t contours;
    struct oracle_edge edge[POINTS];
    int32_t n;
};

static int32_t held(int32_t v)
{
    return v > LIMIT ? LIMIT : v < -LIMIT ? -LIMIT : v;
}

/* A coordinate round a window lo .. hi - 1 px: near it, on centres, on corners, far, extreme. */
static int32_t coordinate(uint32_t *seed, int32_t kind, int32_t lo, int32_t hi)
{
    switch (kind) {
    case 0: return held(test_range(seed, (lo - 8) * 256, (hi + 8) * 256));
    case 1: return held(test_range(seed, lo - 4, hi + 4) * 256 + 128);
    case 2: return held(test_range(seed, lo - 4, hi + 4) * 256);
    case 3: return test_range(seed, -LIMIT, LIMIT);
    case 4: return test_range(seed, 0, 1) != 0 ? LIMIT : -LIMIT;
    case 5: return held(test_range(seed, lo, lo + 3) * 256 + 128); /* many equal */
    default: return held(test_range(seed, lo * 256, hi * 256) / 64 * 64);
    }
}

static void add(struct sample *s, struct etch_point_q8 a, struct etch_point_q8 b)
{
    const struct oracle_edge e = {a.x, a.y, b.x, b.y};

    s->edge[s->n++] = e;
}

/* Up to four contours of 0 .. 10 vertices; in one of four samples each vertex is of its own kind,
 * in some vertices repeat. */
static void make(struct sample *s, struct etch_rect w, uint32_t *seed)
{
    const int32_t kind = test_range(seed, 0, 6);
    const bool mixed = test_range(seed, 0, 3) == 0;
    struct etch_point_q8 *v = s->v;
    uint16_t i, k;

    s->n = 0;
    s->contours = (uint16_t)test_range(seed, 1, 4);
    for (i = 0; i < s->contours; i++) {
        const uint16_t n = s->size[i] = (uint16_t)test_range(seed, 0, 10);

        for (k = 0; k < n; k++) {
            v[k].x = coordinate(seed, mixed ? test_range(seed, 0, 6) : kind, w.x0, w.x1);
            v[k].y = coordinate(seed, mixed ? test_range(seed, 0, 6) : kind, w.y0, w.y1);
            if (k > 0 && test_range(seed, 0, 15) == 0)
                v[k] = v[test_range(seed, 0, k - 1)];
            else if (k > 0 && test_range(seed, 0, 7) == 0)
                v[k].y = v[k - 1].y;
        }
        for (k = 0; n >= 3 && k < n; k++)
            add(s, v[k], v[(k + 1) % n]);
        v += n;
    }
}

static void load(const struct sample *s)
{
    const struct etch_point_q8 *v = s->v;
    uint16_t i;

    etch_polygon_init(&polygon, edges, POINTS);
    for (i = 0; i < s->contours; v += s->size[i++])
        CHECK_EQ(etch_polygon_add(&polygon, v, s->size[i]), ETCH_OK);
}

static void note(const struct sample *s)
{
    int32_t i;

    for (i = 0; i < s->n; i++) {
        test_note("ax", s->edge[i].ax);
        test_note("ay", s->edge[i].ay);
    }
}

typedef void filler(const struct etch_surface *s, struct etch_polygon *p,
                    const struct etch_paint *paint);

/* Draws into the wiped canvas and compares every pixel of the clip. */
static void compare(const struct sample *s, bool nonzero)
{
    filler *const fill = nonzero ? etch_polygon_runs_nonzero : etch_polygon_runs_evenodd;
    const struct etch_rect c = canvas.surface.clip;
    struct test_run_log log;
    const struct test_run_paint paint = test_band_paint(&log, TEST_INK);
    int32_t x, y, wrong = 0;

    fill(&canvas.surface, &polygon, &paint.paint);
    for (y = c.y0; y < c.y1; y++) {
        for (x = c.x0; x < c.x1; x++) {
            int32_t winding;
            const int32_t n = oracle_polygon_crossings(s->edge, s->n, x, y, &winding);

            wrong += (nonzero ? winding != 0 : n % 2 != 0) != test_canvas_drawn(&canvas, x, y);
        }
    }
    if (!CHECK_EQ(wrong, 0) || !CHECK(!log.broken))
        note(s);
    CHECK_INSIDE(&canvas);
    polygons++;
}

static const struct etch_rect windows[] = {
    {0, 0, 40, 36}, {100, 7, 140, 40}, {32727, 32731, 32767, 32767}, {0, 32700, 33, 32733}};

static void covers_what_crossings_say(void)
{
    static struct sample s;
    uint32_t seed = 1;
    int32_t i;

    for (i = 0; i < TEST_COUNT(6000) && !test_failed(); i++) {
        const struct etch_rect w = windows[i % 4];

        test_canvas_open(&canvas, w);
        if (i % 3 == 0) {
            const struct etch_rect clip = {(int16_t)(w.x0 + test_range(&seed, 0, 20)),
                                           (int16_t)(w.y0 + test_range(&seed, 0, 20)),
                                           (int16_t)(w.x1 - test_range(&seed, 0, 20)),
                                           (int16_t)(w.y1 - test_range(&seed, 0, 15))};

            test_canvas_clip(&canvas, clip);
        }
        make(&s, w, &seed);
        load(&s);
        compare(&s, false);
        test_canvas_wipe(&canvas);
        compare(&s, true); /* and the edges are walked a second time */
    }
}

/* A triangle as a polygon, by both rules, has the pixels of etch_triangle_runs. */
static void triangles_are_those_of_the_triangle_walker(void)
{
    const struct etch_rect w = {3, 5, 64, 48};
    uint32_t seed = 2;
    int32_t i, k;

    test_canvas_open(&canvas, w);
    test_canvas_open(&other, w);
    for (i = 0; i < TEST_COUNT(20000) && !test_failed(); i++) {
        struct test_run_log log;
        const struct test_run_paint paint = test_band_paint(&log, TEST_INK);
        struct test_triangle t;
        struct etch_triangle shape;
        struct etch_point_q8 v[3];

        test_triangle_make(&t, (enum test_triangle_kind)(i % TEST_TRIANGLE_KINDS), w, &seed);
        for (k = 0; k < 3; k++)
            v[k].x = t.x[k], v[k].y = t.y[k];
        test_canvas_wipe(&canvas);
        test_canvas_wipe(&other);
        if (etch_triangle_setup(&shape, v))
            etch_triangle_runs(&canvas.surface, &shape, &paint.paint);
        etch_polygon_init(&polygon, edges, 3);
        CHECK_EQ(etch_polygon_add(&polygon, v, 3), ETCH_OK);
        (i % 2 != 0 ? etch_polygon_runs_nonzero
                    : etch_polygon_runs_evenodd)(&other.surface, &polygon, &paint.paint);
        if (!CHECK_EQ(test_canvas_hash(&canvas), test_canvas_hash(&other)))
            for (k = 0; k < 3; k++)
                test_note("x", v[k].x), test_note("y", v[k].y);
    }
}

/* The frame in strips, downwards, upwards and in tiles, with edges that go on from where they
 * were. */
static void strips_are_the_whole(void)
{
    const struct etch_rect w = {0, 0, 60, 48};
    static struct sample s;
    uint32_t seed = 3;
    int32_t i, y;

    for (i = 0; i < TEST_COUNT(2000) && !test_failed(); i++) {
        const int32_t rows = test_range(&seed, 1, 17);
        struct test_run_log log;
        const struct test_run_paint paint = test_band_paint(&log, TEST_INK);

        test_canvas_open(&canvas, w);
        test_canvas_open(&other, w);
        make(&s, w, &seed);
        load(&s);
        etch_polygon_runs_evenodd(&canvas.surface, &polygon, &paint.paint);
        for (y = 0; y < 48; y += rows) {
            const int32_t from = i % 3 == 0 ? 48 - y - rows : y;
            const struct etch_rect left = {0, (int16_t)from, 23, (int16_t)(from + rows)};
            const struct etch_rect right = {23, (int16_t)from, 60, (int16_t)(from + rows)};

            log.next_row = INT32_MIN;
            other.surface.clip = etch_rect_intersect(left, w);
            etch_polygon_runs_evenodd(&other.surface, &polygon, &paint.paint);
            log.next_row = INT32_MIN;
            other.surface.clip = etch_rect_intersect(right, w);
            etch_polygon_runs_evenodd(&other.surface, &polygon, &paint.paint);
        }
        if (!CHECK_EQ(test_canvas_hash(&canvas), test_canvas_hash(&other)) || !CHECK(!log.broken))
            note(&s);
    }
}

/* Two polygons that share a zigzag cover a rectangle once. */
static void neighbours_neither_overlap_nor_part(void)
{
    const struct etch_rect w = {0, 0, 64, 48};
    uint32_t seed = 4;
    int32_t i;
    uint16_t k;

    for (i = 0; i < TEST_COUNT(2000) && !test_failed(); i++) {
        struct etch_point_q8 v[12];
        struct test_run_log log;
        const struct test_run_paint paint = test_band_paint(&log, TEST_INK);

        for (k = 0; k < 10; k++) { /* the zigzag, from top to bottom, and back over itself */
            v[k].x = test_range(&seed, 256, 63 * 256);
            v[k].y = test_range(&seed, 0, 48 * 256);
        }
        v[0].y = 0, v[9].y = 48 * 256;
        test_canvas_open(&canvas, w);
        v[10].x = v[11].x = 0;
        v[10].y = 48 * 256, v[11].y = 0;
        etch_polygon_init(&polygon, edges, 12);
        CHECK_EQ(etch_polygon_add(&polygon, v, 12), ETCH_OK);
        etch_polygon_runs_evenodd(&canvas.surface, &polygon, &paint.paint);
        log.next_row = INT32_MIN;
        v[10].x = v[11].x = 64 * 256;
        etch_polygon_init(&polygon, edges, 12);
        CHECK_EQ(etch_polygon_add(&polygon, v, 12), ETCH_OK);
        etch_polygon_runs_evenodd(&canvas.surface, &polygon, &paint.paint);
        CHECK_EQ(log.pixels, 64 * 48); /* and the kernel refuses a second time */
        CHECK(!log.broken);
    }
}

/* More runs in a row than a band keeps, and rows whose number of runs changes. */
static void combs_have_many_runs(void)
{
    const struct etch_rect w = {0, 0, 64, 48};
    struct etch_point_q8 v[300];
    struct test_run_log log;
    const struct test_run_paint paint = test_band_paint(&log, TEST_INK);
    uint16_t n = 0, k;
    int32_t x, y, wrong = 0, seen = 0;

    for (k = 0; k < 30; k++) { /* teeth of one pixel, longer and longer */
        const int32_t left = 512 * k + 256;

        v[n].x = left, v[n++].y = 0;
        v[n].x = left, v[n++].y = 256 * (k + 2);
        v[n].x = left + 256, v[n++].y = 256 * (k + 2);
        v[n].x = left + 256, v[n++].y = 0;
    }
    test_canvas_open(&canvas, w);
    etch_polygon_init(&polygon, edges, 400);
    CHECK_EQ(etch_polygon_add(&polygon, v, n), ETCH_OK);
    etch_polygon_runs_nonzero(&canvas.surface, &polygon, &paint.paint);
    for (y = 0; y < 48; y++) {
        for (x = 0; x < 64; x++) {
            const bool tooth = x % 2 == 1 && x < 60 && y < x / 2 + 2;

            wrong += tooth != test_canvas_drawn(&canvas, x, y);
            seen += tooth;
        }
    }
    CHECK_EQ(wrong, 0);
    CHECK_EQ(log.pixels, seen);
    CHECK(!log.broken);
}

static void a_star_with_both_rules(void)
{
    static const struct etch_point star[] = {{6, 0}, {10, 11}, {0, 4}, {12, 4}, {2, 11}};
    static const uint16_t size[] = {5};
    const struct etch_rect w = {0, 0, 13, 11};

    test_canvas_open(&canvas, w);
    CHECK_EQ(etch_polygon_fill_evenodd(&canvas.surface, star, size, 1, TEST_INK, edges, 5),
             ETCH_OK);
    CHECK_PICTURE(&canvas, "............."
                           "......#......"
                           "......#......"
                           ".....###....."
                           "#####...####."
                           "..###...###.."
                           "...#.....#..."
                           "....#...#...."
                           "....##.##...."
                           "...##...##..."
                           "...#.....#...");
    CHECK_ONCE(&canvas);
    test_canvas_wipe(&canvas);
    CHECK_EQ(etch_polygon_fill_nonzero(&canvas.surface, star, size, 1, TEST_INK, edges, 5),
             ETCH_OK);
    CHECK_PICTURE(&canvas, "............."
                           "......#......"
                           "......#......"
                           ".....###....."
                           "############."
                           "..#########.."
                           "...#######..."
                           "....#####...."
                           "....#####...."
                           "...##...##..."
                           "...#.....#...");
    CHECK_ONCE(&canvas);
}

static void extremes_of_int16_are_legal(void)
{
    static const struct etch_point v[] = {{-32768, -32768}, {32767, -32768}, {32767, 32767},
                                          {-32768, 32767},  {10, 10},        {10, 20},
                                          {20, 20},         {20, 10}};
    static const uint16_t size[] = {4, 4};
    const struct etch_rect w = {0, 0, 40, 40};
    int32_t x, y, wrong = 0;

    test_canvas_open(&canvas, w);
    CHECK_EQ(etch_polygon_fill_evenodd(&canvas.surface, v, size, 2, TEST_INK, edges, 8), ETCH_OK);
    for (y = 0; y < 40; y++)
        for (x = 0; x < 40; x++)
            wrong += (x >= 10 && x < 20 && y >= 10 && y < 20) == test_canvas_drawn(&canvas, x, y);
    CHECK_EQ(wrong, 0);
    CHECK_ONCE(&canvas);
}

/* Too few edges, vertices out of range: the first failure stays and nothing is drawn. */
static void refuses_what_it_cannot_hold(void)
{
    static const struct etch_point v[] = {{0, 0}, {30, 5}, {30, 30}, {0, 30}};
    static const uint16_t size[] = {4};
    const struct etch_point_q8 far[3] = {{0, 0}, {LIMIT + 1, 0}, {0, 4096}};
    const struct etch_rect w = {0, 0, 40, 40};

    test_canvas_open(&canvas, w);
    CHECK_EQ(etch_polygon_fill_evenodd(&canvas.surface, v, size, 1, TEST_INK, edges, 2),
             ETCH_ENOMEM);
    CHECK_EQ(etch_polygon_fill_nonzero(&canvas.surface, v, size, 1, TEST_INK, NULL, 0),
             ETCH_ENOMEM);
    CHECK(!test_canvas_drawn(&canvas, 10, 20));
    CHECK_EQ(etch_polygon_fill_evenodd(&canvas.surface, v, size, 1, TEST_INK, edges, 3), ETCH_OK);
    CHECK(test_canvas_drawn(&canvas, 10, 20)); /* the horizontal edge took none */
    etch_polygon_init(&polygon, edges, 8);
    CHECK_EQ(etch_polygon_add(&polygon, far, 3), ETCH_EINVAL);
    CHECK_EQ(etch_polygon_add_pixels(&polygon, v, 4), ETCH_EINVAL);
    CHECK_EQ(etch_polygon_add(&polygon, far, 2), ETCH_EINVAL);
    etch_polygon_init(&polygon, edges, 0);
    CHECK_EQ(etch_polygon_add_pixels(&polygon, v, 2), ETCH_OK);
}

/* A star over all of the plane, seen through a few rows: it costs those rows, wherever they are,
 * and the rows after them no division. Counted in blocks of code, where core is built for it. */
static void cost_is_of_what_is_visible(void)
{
    static struct etch_point v[POINTS];
    static const uint16_t size[] = {POINTS};
    uint32_t seed = 5, worst = 0, blocks;
    int32_t i;

    for (i = 0; i < POINTS; i++) {
        v[i].x = (int16_t)test_range(&seed, INT16_MIN, INT16_MAX);
        v[i].y = (int16_t)(i % 2 != 0 ? INT16_MIN : INT16_MAX);
    }
    for (i = 0; i < 50; i++) {
        const int16_t at = (int16_t)test_range(&seed, 0, 32700);

        test_canvas_open(&canvas,
                         (struct etch_rect){at, at, (int16_t)(at + 16), (int16_t)(at + 8)});
        (void)test_blocks();
        CHECK_EQ(etch_polygon_fill_evenodd(&canvas.surface, v, size, 1, TEST_INK, edges, POINTS),
                 ETCH_OK);
        blocks = test_blocks();
        worst = blocks > worst ? blocks : worst;
        CHECK(blocks < 20000 && (!TEST_STORES || blocks > 0));
    }
    if (TEST_STORES)
        test_print_count("8 rows of a star of 40 edges over the plane: ", (int32_t)worst,
                         " blocks at most");
}

void suite_polygon(void)
{
    RUN(covers_what_crossings_say);
    RUN(triangles_are_those_of_the_triangle_walker);
    RUN(strips_are_the_whole);
    RUN(neighbours_neither_overlap_nor_part);
    RUN(combs_have_many_runs);
    RUN(a_star_with_both_rules);
    RUN(extremes_of_int16_are_legal);
    RUN(refuses_what_it_cannot_hold);
    RUN(cost_is_of_what_is_visible);
    test_print_count("", polygons, " polygons, no differing pixel");
}
