/* tests/unit: meshes and fans that tile the whole surface draw every pixel exactly once. */
#include "core/raster/triangle.h"
#include "tests/harness/canvas.h"
#include "tests/harness/shapes.h"

void suite_mesh_cover(void);

#define LIMIT (INT32_C(1) << 23)

static struct test_canvas canvas;
static int32_t meshes, triangles;

static const struct etch_rect windows[] = {
    {0, 0, 64, 48}, {150, 100, 190, 141}, {32727, 32731, 32767, 32767}};

/* Adds 1 to every pixel of the triangle, its vertices in a random order. */
static void add_triangle(struct etch_point_q8 a, struct etch_point_q8 b, struct etch_point_q8 c,
                         uint32_t *seed)
{
    const uint8_t *order = test_orders[test_range(seed, 0, 5)];
    const struct etch_point_q8 p[3] = {a, b, c};
    const struct etch_point_q8 v[3] = {p[order[0]], p[order[1]], p[order[2]]};
    struct etch_triangle t;
    struct test_run_log log;
    struct test_run_paint paint = test_run_paint(&log, 1);

    paint.count = true;
    if (etch_triangle_setup(&t, v))
        etch_triangle_runs(&canvas.surface, &t, &paint.paint);
    CHECK(!log.broken);
    triangles++;
}

static void every_pixel_once(uint32_t seed)
{
    const struct etch_rect w = canvas.surface.window;
    int32_t x, y, wrong = 0;

    for (y = w.y0; y < w.y1; y++)
        for (x = w.x0; x < w.x1; x++)
            wrong += test_canvas_at(&canvas, x, y) != TEST_BACKGROUND + 1;
    if (!CHECK_EQ(wrong, 0))
        test_note("seed", seed);
    CHECK_INSIDE(&canvas);
    meshes++;
}

/* ---- any triangulation, by splitting triangles -------------------------------------------- */

#define MOST_TRIANGLES 256

struct corner_points {
    struct etch_point_q8 p[3];
};

static int64_t side(struct etch_point_q8 a, struct etch_point_q8 b, struct etch_point_q8 p)
{
    return (int64_t)(b.x - a.x) * (p.y - a.y) - (int64_t)(b.y - a.y) * (p.x - a.x);
}

static bool inside(const struct corner_points *t, struct etch_point_q8 p)
{
    return side(t->p[0], t->p[1], p) >= 0 && side(t->p[1], t->p[2], p) >= 0 &&
           side(t->p[2], t->p[0], p) >= 0;
}

/* A point of a clockwise triangle, near a corner or an edge as often as not; snapped to `grid`.
 * False if snapping moved it outside. */
static bool point_in(const struct corner_points *t, int32_t grid, uint32_t *seed,
                     struct etch_point_q8 *p)
{
    const int32_t shrink = test_range(seed, 0, 3) == 0 ? 64 : 1;
    const int32_t b0 = test_range(seed, 0, 65536 / shrink);
    const int32_t b1 = test_range(seed, 0, 65536 - b0);
    const int32_t b2 = 65536 - b0 - b1;

    p->x = (int32_t)(((int64_t)t->p[0].x * b0 + (int64_t)t->p[1].x * b1 + (int64_t)t->p[2].x * b2) /
                     65536);
    p->y = (int32_t)(((int64_t)t->p[0].y * b0 + (int64_t)t->p[1].y * b1 + (int64_t)t->p[2].y * b2) /
                     65536);
    p->x = p->x / grid * grid + (grid == 256 ? 128 : 0);
    p->y = p->y / grid * grid + (grid == 256 ? 128 : 0);
    return inside(t, *p);
}

/* Two triangles over the window, reaching `margin` / 256 px beyond it. */
static void cover_window(struct corner_points *t, struct etch_rect w, int32_t margin)
{
    const int32_t left = w.x0 * 256 - margin, top = w.y0 * 256 - margin;
    const int32_t right = w.x1 * 256 + margin, bottom = w.y1 * 256 + margin;
    const struct etch_point_q8 p[4] = {
        {left < -LIMIT ? -LIMIT : left, top < -LIMIT ? -LIMIT : top},
        {right > LIMIT ? LIMIT : right, top < -LIMIT ? -LIMIT : top},
        {right > LIMIT ? LIMIT : right, bottom > LIMIT ? LIMIT : bottom},
        {left < -LIMIT ? -LIMIT : left, bottom > LIMIT ? LIMIT : bottom}};
    const struct corner_points two[2] = {{{p[0], p[1], p[2]}}, {{p[0], p[2], p[3]}}};

    t[0] = two[0];
    t[1] = two[1];
}

/* Splits a random triangle at a point into three; all stay clockwise or without area. */
static void split(struct corner_points *t, int32_t *n, int32_t grid, uint32_t *seed)
{
    struct corner_points *from = &t[test_range(seed, 0, *n - 1)];
    struct etch_point_q8 p;

    if (!point_in(from, grid, seed, &p))
        return;
    t[*n] = *from;
    t[*n + 1] = *from;
    from->p[2] = p;
    t[*n].p[0] = p;
    t[*n + 1].p[1] = p;
    *n += 2;
}

static void meshes_of_split_triangles(void)
{
    static const int32_t grids[] = {1, 1, 16, 128, 256};
    static const int32_t margins[] = {0, 1, 77, 5000, 2 * LIMIT};
    static struct corner_points t[MOST_TRIANGLES + 2];
    uint32_t seed = 31;
    int32_t i, k, n;

    for (i = 0; i < TEST_COUNT(2000) && !test_failed(); i++) {
        const uint32_t start = seed;
        const struct etch_rect w = windows[i % 3];
        const int32_t splits = test_range(&seed, 0, MOST_TRIANGLES / 2 - 1);

        test_canvas_open(&canvas, w);
        cover_window(t, w, margins[i % 5]);
        n = 2;
        for (k = 0; k < splits; k++)
            split(t, &n, grids[i / 5 % 5], &seed);
        for (k = 0; k < n; k++)
            add_triangle(t[k].p[0], t[k].p[1], t[k].p[2], &seed);
        every_pixel_once(start);
    }
}

/* ---- a grid of quads, as a height field or a sphere has ------------------------------------- */

static void jittered_grids(void)
{
    static struct etch_point_q8 p[9][9];
    uint32_t seed = 32;
    int32_t i, x, y;

    for (i = 0; i < TEST_COUNT(2000) && !test_failed(); i++) {
        const uint32_t start = seed;
        const struct etch_rect w = windows[i % 2];
        const int32_t cell = test_range(&seed, 9, 60) * 256, jitter = cell / 4 - 1;

        test_canvas_open(&canvas, w);
        for (y = 0; y < 9; y++) {
            for (x = 0; x < 9; x++) {
                p[y][x].x = w.x0 * 256 + (x - 1) * cell + test_range(&seed, -jitter, jitter);
                p[y][x].y = w.y0 * 256 + (y - 1) * cell + test_range(&seed, -jitter, jitter);
                if (x == 8)
                    p[y][x].x = LIMIT;
                if (y == 8)
                    p[y][x].y = LIMIT;
            }
        }
        for (y = 0; y < 8; y++) {
            for (x = 0; x < 8; x++) {
                add_triangle(p[y][x], p[y][x + 1], p[y + 1][x], &seed);
                add_triangle(p[y][x + 1], p[y + 1][x + 1], p[y + 1][x], &seed);
            }
        }
        every_pixel_once(start);
    }
}

/* ---- fans round a point of the window -------------------------------------------------------- */

/* The k-th of 4 * steps points round the square of +-LIMIT. */
static struct etch_point_q8 rim(int32_t k, int32_t steps)
{
    const int32_t along = -LIMIT + (int32_t)((int64_t)2 * LIMIT * (k % steps) / steps);
    const struct etch_point_q8 p[4] = {
        {along, -LIMIT}, {LIMIT, along}, {-along, LIMIT}, {-LIMIT, -along}};

    return p[k / steps % 4];
}

static void fans(void)
{
    uint32_t seed = 33;
    int32_t i, k;

    for (i = 0; i < TEST_COUNT(2000) && !test_failed(); i++) {
        const uint32_t start = seed;
        const struct etch_rect w = windows[i % 3];
        const int32_t steps = test_range(&seed, 1, 24);
        const int32_t grid = i % 2 == 0 ? 1 : 128;
        const struct etch_point_q8 centre = {
            test_range(&seed, w.x0 * 256, w.x1 * 256) / grid * grid,
            test_range(&seed, w.y0 * 256, w.y1 * 256) / grid * grid};

        test_canvas_open(&canvas, w);
        for (k = 0; k < 4 * steps; k++)
            add_triangle(centre, rim(k, steps), rim(k + 1, steps), &seed);
        every_pixel_once(start);
    }
}

void suite_mesh_cover(void)
{
    meshes = 0;
    triangles = 0;
    RUN(meshes_of_split_triangles);
    RUN(jittered_grids);
    RUN(fans);
    test_print_count("", meshes, " meshes and fans over the whole surface, each pixel once");
    test_print_count("of ", triangles, " triangles");
}
