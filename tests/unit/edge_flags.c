/* tests/unit: polygons by inverted bits: against the whole-row inversion that the method comes
 * from, and against polygons by scan lines. */
#include "core/raster/edge_flags.h"
#include "tests/harness/bands.h"
#include "tests/oracle/polygon.h"

void suite_edge_flags(void);

enum {
    POINTS = 60,
    LIMIT = 1 << 23
};

static struct test_canvas canvas, other;
static uint8_t bits[ETCH_EDGE_FLAGS_BYTES(64, 48)];

/* Edge inversion by its definition: everything right of an edge, row by row, is inverted. */
static void invert(bool inside[48][64], struct etch_rect w, struct etch_point_q8 a,
                   struct etch_point_q8 b)
{
    const struct oracle_edge edge = {a.x, a.y, b.x, b.y};
    int32_t x, y, winding;

    for (y = w.y0; y < w.y1; y++)
        for (x = w.x0; x < w.x1; x++)
            inside[y - w.y0][x - w.x0] ^= oracle_polygon_crossings(&edge, 1, x, y, &winding) != 0;
}

static struct etch_point_q8 point(uint32_t *seed, struct etch_rect w)
{
    const bool far = test_range(seed, 0, 7) == 0;
    struct etch_point_q8 p;

    p.x = test_range(seed, far ? -LIMIT : (w.x0 - 9) * 256, far ? LIMIT : (w.x1 + 9) * 256);
    p.y = test_range(seed, far ? -LIMIT : (w.y0 - 9) * 256, far ? LIMIT : (w.y1 + 9) * 256);
    if (test_range(seed, 0, 3) == 0)
        p.x = p.x / 256 * 256 + 128, p.y = p.y / 256 * 256 + 128;
    return p;
}

static void inverts_what_edges_say(void)
{
    static const struct etch_rect rects[] = {{0, 0, 64, 48}, {3, 5, 44, 40}, {17, 0, 18, 48}};
    static bool inside[48][64];
    uint32_t seed = 1;
    int32_t i, x, y;

    for (i = 0; i < TEST_COUNT(1500) && !test_failed(); i++) {
        const struct etch_rect w = {0, 0, 64, 48}, r = rects[i % 3];
        const uint16_t n = (uint16_t)test_range(&seed, 0, POINTS);
        struct etch_point_q8 v[POINTS];
        struct etch_edge_flags flags;
        struct test_run_log log;
        const struct test_run_paint paint = test_band_paint(&log, TEST_INK);
        int32_t wrong = 0;
        uint16_t k;

        CHECK_EQ(etch_edge_flags_init(&flags, r, bits, sizeof bits), ETCH_OK);
        for (y = 0; y < 48; y++)
            for (x = 0; x < 64; x++)
                inside[y][x] = false;
        for (k = 0; k < n; k++)
            v[k] = point(&seed, w);
        for (k = 0; k < n; k++)
            invert(inside, w, v[k], v[(k + 1) % n]);
        etch_edge_flags_add(&flags, v, n);
        test_canvas_open(&canvas, w);
        if (i % 2 != 0)
            test_canvas_clip(&canvas, (struct etch_rect){9, 8, 50, 33});
        etch_edge_flags_runs(&canvas.surface, &flags, &paint.paint);
        for (y = canvas.surface.clip.y0; y < canvas.surface.clip.y1; y++)
            for (x = canvas.surface.clip.x0; x < canvas.surface.clip.x1; x++)
                wrong += test_canvas_drawn(&canvas, x, y) !=
                         (inside[y][x] && x >= r.x0 && x < r.x1 && y >= r.y0 && y < r.y1);
        CHECK_EQ(wrong, 0);
        CHECK(!log.broken);
        CHECK_INSIDE(&canvas);
    }
}

static void is_the_evenodd_polygon(void)
{
    static struct etch_polygon_edge edges[POINTS];
    const struct etch_rect w = {100, 200, 164, 248};
    uint32_t seed = 2;
    int32_t i;

    test_canvas_open(&canvas, w);
    test_canvas_open(&other, w);
    for (i = 0; i < TEST_COUNT(3000) && !test_failed(); i++) {
        struct etch_point_q8 v[POINTS];
        struct etch_polygon polygon;
        struct etch_edge_flags flags;
        struct test_run_log log;
        const struct test_run_paint paint = test_band_paint(&log, TEST_INK);
        uint16_t k;

        for (k = 0; k < POINTS; k++)
            v[k] = point(&seed, w);
        etch_polygon_init(&polygon, edges, POINTS);
        CHECK_EQ(etch_polygon_add(&polygon, v, POINTS), ETCH_OK);
        CHECK_EQ(etch_edge_flags_init(&flags, w, bits, sizeof bits), ETCH_OK);
        etch_edge_flags_add(&flags, v, POINTS);
        test_canvas_wipe(&canvas);
        test_canvas_wipe(&other);
        etch_polygon_runs_evenodd(&canvas.surface, &polygon, &paint.paint);
        log.next_row = INT32_MIN;
        etch_edge_flags_runs(&other.surface, &flags, &paint.paint);
        CHECK_EQ(test_canvas_hash(&canvas), test_canvas_hash(&other));
        CHECK(!log.broken);
    }
}

static void refuses_too_little_memory(void)
{
    struct etch_edge_flags flags;

    CHECK_EQ(ETCH_EDGE_FLAGS_BYTES(9, 3), 6);
    CHECK_EQ(etch_edge_flags_init(&flags, (struct etch_rect){0, 0, 9, 3}, bits, 5), ETCH_ENOMEM);
    CHECK_EQ(etch_edge_flags_init(&flags, (struct etch_rect){0, 0, 9, 3}, bits, 6), ETCH_OK);
    CHECK_EQ(etch_edge_flags_init(&flags, (struct etch_rect){4, 0, 4, 3}, bits, 6), ETCH_EINVAL);
    CHECK_EQ(
        etch_edge_flags_init(&flags, (struct etch_rect){-32768, -32768, 32767, 32767}, bits, 99),
        ETCH_ENOMEM);
}

void suite_edge_flags(void)
{
    RUN(inverts_what_edges_say);
    RUN(is_the_evenodd_polygon);
    RUN(refuses_too_little_memory);
}
