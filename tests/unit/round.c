/* tests/unit: ellipses, rounded rectangles, rings, arcs and pies against their definitions. */
#include "core/draw/round.h"
#include "core/draw/shapes.h"
#include "core/raster/arc.h"
#include "core/raster/circle.h"
#include "core/raster/ellipse.h"
#include "core/raster/round_rect.h"
#include "tests/harness/bands.h"
#include "tests/oracle/circle.h"
#include "tests/oracle/round.h"

void suite_round(void);

static struct test_canvas canvas, other;
static int32_t shapes;

enum kind {
    ELLIPSE,
    ROUND_RECT,
    RING,
    ARC,
    KINDS
};

/* p: centre and radii; or corner, sides and radius; or centre, outer and inner radius. */
struct shape {
    enum kind kind;
    int16_t x, y, p, q, r;
    uint16_t from;
    uint32_t sweep;
};

static bool covers(const struct shape *s, int32_t x, int32_t y)
{
    const int32_t dx = x - s->x, dy = y - s->y;

    switch (s->kind) {
    case ELLIPSE: return oracle_ellipse_covers(s->p, s->q, dx, dy);
    case ROUND_RECT: return oracle_round_rect_covers(s->p, s->q, s->r, dx, dy);
    case RING: return oracle_arc_covers(s->p, s->q, 0, 65536, dx, dy);
    default: return oracle_arc_covers(s->p, s->q, s->from, s->sweep, dx, dy);
    }
}

static bool covers_border(const struct shape *s, int32_t x, int32_t y)
{
    return covers(s, x, y) && !(covers(s, x - 1, y) && covers(s, x + 1, y) && covers(s, x, y - 1) &&
                                covers(s, x, y + 1));
}

static bool covers_line(const struct shape *s, int32_t x, int32_t y)
{
    return oracle_circle_covers(s->p, x - s->x, y - s->y) &&
           oracle_sector_covers(s->from, s->sweep, x - s->x, y - s->y);
}

static void fill(const struct etch_surface *to, const struct shape *s, const struct etch_paint *p)
{
    switch (s->kind) {
    case ELLIPSE: etch_ellipse_runs(to, s->x, s->y, s->p, s->q, p); break;
    case ROUND_RECT: etch_round_rect_runs(to, s->x, s->y, s->p, s->q, s->r, p); break;
    case RING: etch_ring_runs(to, s->x, s->y, s->p, s->q, p); break;
    default: etch_arc_runs(to, s->x, s->y, s->p, s->q, s->from, s->sweep, p); break;
    }
}

static void border(const struct etch_surface *to, const struct shape *s, const struct etch_paint *p)
{
    switch (s->kind) {
    case ELLIPSE: etch_ellipse_outline_runs(to, s->x, s->y, s->p, s->q, p); break;
    case ROUND_RECT: etch_round_rect_outline_runs(to, s->x, s->y, s->p, s->q, s->r, p); break;
    case RING: etch_ring_outline_runs(to, s->x, s->y, s->p, s->q, p); break;
    default: etch_arc_outline_runs(to, s->x, s->y, s->p, s->q, s->from, s->sweep, p); break;
    }
}

static void line(const struct etch_surface *to, const struct shape *s, const struct etch_paint *p)
{
    etch_arc_line_runs(to, s->x, s->y, s->p, s->from, s->sweep, p);
}

typedef bool coverage(const struct shape *s, int32_t x, int32_t y);
typedef void drawer(const struct etch_surface *to, const struct shape *s,
                    const struct etch_paint *p);

static const struct {
    drawer *draw;
    coverage *covers;
} ways[] = {{fill, covers}, {border, covers_border}, {line, covers_line}};

/* Draws on the wiped canvas and compares its clip. */
static void try_way(const struct shape *s, int way)
{
    const struct etch_rect clip = canvas.surface.clip;
    struct test_run_log log;
    const struct test_run_paint paint = test_band_paint(&log, TEST_INK);
    int32_t wrong = 0;

    ways[way].draw(&canvas.surface, s, &paint.paint);
    for (int32_t y = clip.y0; y < clip.y1; y++)
        for (int32_t x = clip.x0; x < clip.x1; x++)
            wrong += ways[way].covers(s, x, y) != test_canvas_drawn(&canvas, x, y);
    if (!CHECK_EQ(wrong, 0) || log.broken) {
        test_note("kind", s->kind), test_note("way", way);
        test_note("x", s->x), test_note("y", s->y);
        test_note("p", s->p), test_note("q", s->q), test_note("r", s->r);
        test_note("from", s->from), test_note("sweep", s->sweep);
    }
    CHECK(!log.broken);
    CHECK_ONCE(&canvas);
    shapes++;
}

static void try_shape(const struct shape *s)
{
    for (int way = 0; way < (s->kind == ARC ? 3 : 2); way++) {
        test_canvas_wipe(&canvas);
        try_way(s, way);
    }
}

static const struct etch_rect window = {0, 0, 48, 44};

/* All radii 0 .. 18, with the centre on the canvas: every pixel is seen. */
static void every_small_ellipse(void)
{
    test_canvas_open(&canvas, window);
    for (int16_t rx = 0; rx <= 18; rx++)
        for (int16_t ry = 0; ry <= 18; ry = (int16_t)(ry + TEST_DIVISOR)) {
            const struct shape s = {ELLIPSE, 22, 20, rx, ry, 0, 0, 0};

            try_shape(&s);
        }
}

/* The disc and the circle of circle.h, called directly. */
static void equal_radii_are_circles(void)
{
    for (int16_t r = -1; r <= 23; r++) {
        test_canvas_open(&canvas, window);
        test_canvas_open(&other, window);
        etch_ellipse_fill(&canvas.surface, 24, 23, r, r, TEST_INK);
        etch_circle_fill(&other.surface, 24, 23, r, TEST_INK);
        CHECK_EQ(test_canvas_hash(&canvas), test_canvas_hash(&other));
        CHECK_ONCE(&canvas);
        test_canvas_wipe(&canvas), test_canvas_wipe(&other);
        etch_ellipse_draw(&canvas.surface, 24, 23, r, r, TEST_INK);
        etch_circle_draw(&other.surface, 24, 23, r, TEST_INK);
        CHECK_EQ(test_canvas_hash(&canvas), test_canvas_hash(&other));
        test_canvas_wipe(&canvas);
        etch_arc_draw(&canvas.surface, 24, 23, r, 12345, 65536, TEST_INK);
        CHECK_EQ(test_canvas_hash(&canvas), test_canvas_hash(&other));
        CHECK_ONCE(&canvas);
    }
}

static void every_small_rectangle(void)
{
    test_canvas_open(&canvas, window);
    for (int16_t w = 0; w <= 11; w++)
        for (int16_t h = 0; h <= 11; h = (int16_t)(h + TEST_DIVISOR))
            for (int16_t r = -1; r <= 6; r++) {
                const struct shape s = {ROUND_RECT, 3, 2, w, h, r, 0, 0};

                try_shape(&s);
            }
}

static void small_rings_and_arcs(void)
{
    uint32_t seed = 5;

    test_canvas_open(&canvas, window);
    for (int16_t outer = -1; outer <= 19; outer++)
        for (int16_t inner = -1; inner <= outer + 1; inner = (int16_t)(inner + TEST_DIVISOR)) {
            struct shape s = {RING, 22, 20, outer, inner, 0, 0, 65536};

            try_shape(&s);
            s.kind = ARC;
            for (int i = 0; i < 4; i++) {
                s.from = (uint16_t)(i == 0 ? test_range(&seed, 0, 7) * 8192
                                           : test_range(&seed, 0, 65535));
                s.sweep = (uint32_t)(i < 2 ? test_range(&seed, 0, 8) * 8192
                                           : test_range(&seed, 0, 65536));
                try_shape(&s);
            }
        }
}

static int16_t held(int32_t v)
{
    return (int16_t)(v > INT16_MAX ? INT16_MAX : v < INT16_MIN ? INT16_MIN : v);
}

/* A radius, small or of any size. */
static int16_t radius(uint32_t *seed)
{
    const int32_t most[5] = {3, 30, 300, 5000, INT16_MAX};

    return (int16_t)test_range(seed, 0, most[test_range(seed, 0, 4)]);
}

/* A centre from which something r away passes near `at`, or any. */
static int16_t near_to(uint32_t *seed, int32_t at, int32_t r)
{
    const int32_t off = test_range(seed, 0, 3) == 0 ? test_range(seed, 0, r) : r;
    const int32_t v = at + (test_range(seed, 0, 1) != 0 ? off : -off);

    return test_range(seed, 0, 9) == 0 ? (int16_t)test_random(seed) : held(v);
}

static void draw_random(uint32_t *seed, int32_t i)
{
    const struct etch_rect w = {(int16_t)(i % 3 * 300), (int16_t)(i % 2 * 32719),
                                (int16_t)(i % 3 * 300 + 64), (int16_t)(i % 2 * 32719 + 48)};
    struct etch_rect clip = w;
    struct shape s = {(enum kind)(i % KINDS), 0, 0, radius(seed), radius(seed), 0, 0, 65536};

    s.r = radius(seed);
    s.x = near_to(seed, test_range(seed, w.x0, w.x1), s.p);
    s.y = near_to(seed, test_range(seed, w.y0, w.y1), s.kind == ELLIPSE ? s.q : s.p);
    if (s.kind == ROUND_RECT) {
        s.y = near_to(seed, test_range(seed, w.y0, w.y1), s.q);
        s.r = i % 5 == 0 ? s.r : (int16_t)test_range(seed, 0, 40);
    } else if (s.kind != ELLIPSE && i % 3 != 0) {
        s.q = (int16_t)(s.p - test_range(seed, 0, 12));
    }
    s.from = (uint16_t)test_random(seed);
    s.sweep = (uint32_t)test_range(seed, 0, i % 7 == 0 ? 200 : 65536);
    if (i % 11 == 0) /* more than a turn: all of it */
        s.sweep = test_random(seed) | 65536;
    clip.x0 = (int16_t)(clip.x0 + test_range(seed, 0, 40));
    clip.x1 = (int16_t)(clip.x1 - test_range(seed, 0, 20));
    clip.y1 = (int16_t)(clip.y1 - test_range(seed, 0, 30));
    test_canvas_open(&canvas, w);
    test_canvas_clip(&canvas, clip);
    try_shape(&s);
}

/* Radii to 32,767 whose edges cross the window, on corners of the frame, and anything else. */
static void clipped_shapes(void)
{
    uint32_t seed = 3;

    for (int32_t i = 0; i < TEST_COUNT(2400) && !test_failed(); i++)
        draw_random(&seed, i);
}

/* All combinations of the ends of int16. */
static void shapes_at_the_ends(void)
{
    static const int16_t ends[] = {INT16_MIN, 0, 20, INT16_MAX};
    static const int16_t radii[] = {INT16_MIN, -1, 0, 1, INT16_MAX};
    static const uint16_t angles[] = {0, 1, 16383, 16384, 32767, 32768, 49152, 65535};
    static const uint32_t sweeps[] = {0, 1, 32767, 32768, 32769, 65535, 65536, UINT32_MAX};

    test_canvas_open(&canvas, (struct etch_rect){0, 0, 40, 30});
    for (int32_t i = 0; i < 4 * 4 * 5 * 5 * KINDS; i = i + (TEST_DIVISOR > 1 ? 7 : 1)) {
        struct shape s = {(enum kind)(i % KINDS),
                          ends[i / 4 % 4],
                          ends[i / 16 % 4],
                          radii[i / 64 % 5],
                          radii[i / 320],
                          radii[i % 5],
                          0,
                          0};

        for (int k = 0; k < (s.kind == ARC ? 3 : 1); k++) {
            s.from = angles[(i + k) % 8];
            s.sweep = sweeps[(i / 8 + k) % 8];
            try_shape(&s);
        }
    }
}

/* Parts between the same rays: each pixel of the disc in one of them; rings likewise. */
static void parts_make_the_whole(void)
{
    uint32_t seed = 9;

    test_canvas_open(&canvas, window);
    for (int32_t i = 0; i < TEST_COUNT(300) && !test_failed(); i++) {
        const int32_t parts = test_range(&seed, 1, 7);
        const uint16_t start = (uint16_t)test_random(&seed);
        const int16_t x = (int16_t)test_range(&seed, -5, 50),
                      y = (int16_t)test_range(&seed, -5, 50);
        const int16_t r = (int16_t)test_range(&seed, 0, 60),
                      inner = (int16_t)test_range(&seed, -1, r);
        struct test_run_log log;
        struct test_run_paint paint = test_tile_paint(&log, TEST_INK);
        uint32_t at = 0;
        int32_t wrong = 0;

        test_canvas_wipe(&canvas);
        for (int32_t k = 1; k <= parts; k++) {
            const uint32_t to = k == parts ? 65536
                                           : (uint32_t)test_range(&seed, (int32_t)at, 65535);

            etch_arc_runs(&canvas.surface, x, y, r, inner, (uint16_t)(start + at), to - at,
                          &paint.paint);
            at = to;
        }
        etch_arc_runs(&canvas.surface, x, y, inner, -1, start, 65536, &paint.paint);
        for (int32_t p = 0; p < 48 * 44; p++)
            wrong += test_canvas_drawn(&canvas, p % 48, p / 48) !=
                     oracle_disc_covers(r, p % 48 - x, p / 48 - y);
        CHECK_EQ(wrong, 0);
        CHECK(!log.broken); /* no pixel twice */
    }
}

static void strips_are_the_whole(void)
{
    uint32_t seed = 11;

    for (int32_t i = 0; i < TEST_COUNT(200) && !test_failed(); i++) {
        const struct shape s = {(enum kind)(i % KINDS),
                                (int16_t)test_range(&seed, -20, 60),
                                (int16_t)test_range(&seed, -20, 60),
                                (int16_t)test_range(&seed, 0, 70),
                                (int16_t)test_range(&seed, 0, 70),
                                (int16_t)test_range(&seed, 0, 20),
                                (uint16_t)test_random(&seed),
                                (uint32_t)test_range(&seed, 0, 65536)};
        const int32_t rows = test_range(&seed, 1, 17);

        for (int way = 0; way < 2; way++) {
            struct test_run_log log;
            const struct test_run_paint paint = test_tile_paint(&log, TEST_INK);

            test_canvas_open(&canvas, window);
            test_canvas_open(&other, window);
            ways[way].draw(&canvas.surface, &s, &paint.paint);
            for (int32_t y = 0; y < 44; y += rows) {
                const struct etch_rect strip = {0, (int16_t)y, 48, (int16_t)(y + rows)};

                etch_surface_clip(&other.surface, strip);
                ways[way].draw(&other.surface, &s, &paint.paint);
            }
            etch_surface_clip(&other.surface, window);
            CHECK_EQ(test_canvas_hash(&canvas), test_canvas_hash(&other));
        }
    }
}

static void pictures(void)
{
    test_canvas_open(&canvas, (struct etch_rect){0, 0, 13, 7});
    etch_ellipse_draw(&canvas.surface, 6, 3, 6, 3, TEST_INK);
    CHECK_PICTURE(&canvas, "...#######..."
                           ".##.......##."
                           "#...........#"
                           "#...........#"
                           "#...........#"
                           ".##.......##."
                           "...#######...");
    test_canvas_wipe(&canvas);
    etch_round_rect_draw(&canvas.surface, 1, 0, 10, 7, 2, TEST_INK);
    CHECK_PICTURE(&canvas, "..########..."
                           ".#........#.."
                           ".#........#.."
                           ".#........#.."
                           ".#........#.."
                           ".#........#.."
                           "..########...");
    test_canvas_wipe(&canvas);
    etch_pie_fill(&canvas.surface, 6, 3, 3, 8192, 49152, TEST_INK);
    CHECK_PICTURE(&canvas, ".....###....."
                           "....####....."
                           "...####......"
                           "...###......."
                           "...#####....."
                           "....#####...."
                           ".....###.....");
    test_canvas_wipe(&canvas);
    etch_ring_draw(&canvas.surface, 6, 3, 3, 0, TEST_INK);
    CHECK_ONCE(&canvas);
}

/* The named functions are the runs. */
static void named_functions_are_the_runs(void)
{
    const struct shape s = {ARC, 20, 20, 18, 9, 0, 5000, 40000};
    struct shape pie = s;

    pie.q = -1;
    for (int i = 0; i < 6; i++) {
        const struct shape *const shape = i < 2 ? &s : &pie;
        int32_t wrong = 0;

        test_canvas_open(&canvas, window);
        switch (i) {
        case 0: etch_arc_fill(&canvas.surface, 20, 20, 18, 9, 5000, 40000, TEST_INK); break;
        case 1: etch_arc_draw(&canvas.surface, 20, 20, 18, 5000, 40000, TEST_INK); break;
        case 2: etch_pie_fill(&canvas.surface, 20, 20, 18, 5000, 40000, TEST_INK); break;
        case 3: etch_pie_draw(&canvas.surface, 20, 20, 18, 5000, 40000, TEST_INK); break;
        case 4: etch_ring_fill(&canvas.surface, 20, 20, 18, 9, TEST_INK); break;
        default: etch_ring_draw(&canvas.surface, 20, 20, 18, 9, TEST_INK); break;
        }
        for (int32_t p = 0; p < 48 * 44; p++) {
            struct shape full = s;
            const int32_t x = p % 48, y = p / 48;

            full.kind = RING;
            const bool expected = i == 0   ? covers(shape, x, y)
                                  : i == 1 ? covers_line(shape, x, y)
                                  : i == 2 ? covers(shape, x, y)
                                  : i == 3 ? covers_border(shape, x, y)
                                  : i == 4 ? covers(&full, x, y)
                                           : covers_border(&full, x, y);

            wrong += expected != test_canvas_drawn(&canvas, x, y);
        }
        CHECK_EQ(wrong, 0);
        CHECK_ONCE(&canvas);
    }
}

void suite_round(void)
{
    shapes = 0;
    RUN(pictures);
    RUN(every_small_ellipse);
    RUN(equal_radii_are_circles);
    RUN(every_small_rectangle);
    RUN(small_rings_and_arcs);
    RUN(clipped_shapes);
    RUN(shapes_at_the_ends);
    RUN(parts_make_the_whole);
    RUN(strips_are_the_whole);
    RUN(named_functions_are_the_runs);
    test_print_count("", shapes, " round shapes and outlines on a window, no differing pixel");
}
