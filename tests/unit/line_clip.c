/* tests/unit: lines and polygons cut at a rectangle, against exact rational arithmetic. */
#include "core/raster/clip_polygon.h"
#include "core/raster/line_clip.h"
#include "tests/harness/harness.h"
#include "tests/oracle/wide.h"

void suite_line_clip(void);

/* ---- the oracle: every side as an interval of t = n / d ---------------------------------------
 */

struct fraction {
    int64_t n, d; /* 0 <= n <= d < 2^33 */
};

static uint64_t size(int64_t v)
{
    return v < 0 ? (uint64_t)-v : (uint64_t)v;
}

/* The sign of a b - c d. */
static int compare(int64_t a, int64_t b, int64_t c, int64_t d)
{
    const bool minus_x = (a < 0) != (b < 0), minus_y = (c < 0) != (d < 0);
    const struct wide x = wide_product(size(a), size(b)), y = wide_product(size(c), size(d));
    const int more = !wide_at_most(x, y) ? 1 : wide_at_most(y, x) ? 0 : -1;
    const struct wide zero = {0, 0};

    if (wide_at_most(x, zero) && wide_at_most(y, zero))
        return 0;
    if (minus_x != minus_y)
        return minus_x ? -1 : 1;
    return minus_x ? -more : more;
}

struct exact {
    bool empty, cut[2];
    struct fraction t[2];
};

/* The part of p[0] p[1] with distance >= 0, which is d0 at one end and d1 at the other. */
static void exact_side(struct exact *e, int64_t d0, int64_t d1)
{
    const struct fraction t = {(int64_t)size(d0), (int64_t)size(d0 - d1)};

    if (d0 < 0 && d1 < 0)
        e->empty = true;
    else if (d0 < 0 && (!e->cut[0] || compare(t.n, e->t[0].d, e->t[0].n, t.d) > 0))
        e->t[0] = t, e->cut[0] = true;
    else if (d1 < 0 && (!e->cut[1] || compare(t.n, e->t[1].d, e->t[1].n, t.d) < 0))
        e->t[1] = t, e->cut[1] = true;
}

static struct exact exact_line(const struct etch_bounds *r, const struct etch_point_s32 p[2])
{
    struct exact e = {false, {false, false}, {{0, 1}, {1, 1}}};

    exact_side(&e, (int64_t)p[0].x - r->x0, (int64_t)p[1].x - r->x0);
    exact_side(&e, r->x1 - (int64_t)p[0].x, r->x1 - (int64_t)p[1].x);
    exact_side(&e, (int64_t)p[0].y - r->y0, (int64_t)p[1].y - r->y0);
    exact_side(&e, r->y1 - (int64_t)p[0].y, r->y1 - (int64_t)p[1].y);
    if (!e.empty && compare(e.t[0].n, e.t[1].d, e.t[1].n, e.t[0].d) > 0)
        e.empty = true;
    return e;
}

/* got = a + (b - a) n / d rounded half up. */
static bool is_rounded(int32_t got, int32_t a, int32_t b, struct fraction t)
{
    const int64_t twice = 2 * ((int64_t)got - a), rise = 2 * ((int64_t)b - a);

    return compare(rise, t.n, twice - 1, t.d) >= 0 && compare(rise, t.n, twice + 1, t.d) < 0;
}

/* ---- input ----------------------------------------------------------------------------------- */

static int32_t coordinate(int kind, uint32_t *seed)
{
    static const int32_t ends[] = {INT32_MIN, INT32_MAX, INT32_MIN + 1, INT32_MAX - 1, 0,
                                   1,         -1,        32767,         -32768,        8388608,
                                   77,        -8388608};
    const int32_t any = (int32_t)test_random(seed);

    switch (kind) {
    case 0: return any;
    case 1: return test_range(seed, -6, 6);
    case 2: return ends[test_range(seed, 0, 11)];
    case 3: return test_range(seed, -60000, 60000);
    default: return any >> test_range(seed, 0, 31);
    }
}

static void random_bounds(struct etch_bounds *r, int kind, uint32_t *seed)
{
    const int32_t x = coordinate(kind, seed), y = coordinate(kind, seed);
    const int32_t w = coordinate(kind, seed), h = coordinate(kind, seed);
    const struct etch_bounds b = {x < w ? x : w, y < h ? y : h, x < w ? w : x, y < h ? h : y};

    *r = b;
}

static void note(const struct etch_bounds *r, const struct etch_point_s32 *p, int n)
{
    int i;

    test_note("x0", r->x0);
    test_note("y0", r->y0);
    test_note("x1", r->x1);
    test_note("y1", r->y1);
    for (i = 0; i < n; i++) {
        test_note("x", p[i].x);
        test_note("y", p[i].y);
    }
}

static bool same(struct etch_point_s32 a, struct etch_point_s32 b)
{
    return a.x == b.x && a.y == b.y;
}

/* ---- lines ----------------------------------------------------------------------------------- */

static bool check_line(const struct etch_bounds *r, const struct etch_point_s32 p[2],
                       const struct etch_point_s32 got[2])
{
    const struct exact e = exact_line(r, p);
    bool ok = true;
    int i;

    for (i = 0; i < 2 && ok; i++) {
        if (!e.cut[i])
            ok = CHECK(same(got[i], p[i]));
        else /* exactly on a side, and as far along as the exact point: both are rounded ones */
            ok = CHECK(got[i].x >= r->x0 && got[i].x <= r->x1 && got[i].y >= r->y0 &&
                       got[i].y <= r->y1) &&
                 CHECK(is_rounded(got[i].x, p[0].x, p[1].x, e.t[i]) &&
                       is_rounded(got[i].y, p[0].y, p[1].y, e.t[i]));
    }
    return ok;
}

/* Both algorithms in both directions. */
static void lines_are_exact(void)
{
    uint32_t seed = 1;
    int32_t n, kept = 0;

    for (n = 0; n < TEST_COUNT(200000) && !test_failed(); n++) {
        struct etch_bounds r;
        struct etch_point_s32 p[2], a[2], b[2], c[2];
        bool got;
        int i;

        random_bounds(&r, n % 5, &seed);
        for (i = 0; i < 2; i++)
            p[i].x = coordinate(n % 5, &seed), p[i].y = coordinate(n % 5, &seed);
        a[0] = b[0] = c[1] = p[0];
        a[1] = b[1] = c[0] = p[1];
        got = etch_line_clip_liang_barsky(&r, a);
        if (!CHECK_EQ(got, !exact_line(&r, p).empty) || (got && !check_line(&r, p, a)) ||
            !CHECK_EQ(etch_line_clip_cohen_sutherland(&r, b), got) ||
            !CHECK(same(a[0], b[0]) && same(a[1], b[1])) ||
            !CHECK_EQ(etch_line_clip_cohen_sutherland(&r, c), got) ||
            !CHECK(same(a[0], c[1]) && same(a[1], c[0])))
            note(&r, p, 2);
        kept += got;
    }
    CHECK(kept > TEST_COUNT(20000));
    test_print_count("", n, " lines cut by two algorithms, no end off the exact one rounded");
}

/* ---- polygons -------------------------------------------------------------------------------- */

#define MOST 8
#define ROOM (MOST * 6 + 8)

struct polygon {
    int n;
    struct etch_point_s32 p[ROOM];
};

static void collect(void *context, struct etch_point_s32 p)
{
    struct polygon *polygon = (struct polygon *)context;

    if (CHECK(polygon->n < ROOM))
        polygon->p[polygon->n++] = p;
}

static void clip(const struct etch_bounds *r, const struct polygon *in, struct polygon *out)
{
    struct etch_clip_polygon c;
    int i;

    out->n = 0;
    etch_clip_polygon_begin(&c, r, collect, out);
    for (i = 0; i < in->n; i++)
        etch_clip_polygon_vertex(&c, in->p[i]);
    etch_clip_polygon_end(&c);
}

static void random_polygon(struct polygon *p, int kind, uint32_t *seed)
{
    int i;

    p->n = test_range(seed, 0, MOST);
    for (i = 0; i < p->n; i++)
        p->p[i].x = coordinate(kind, seed), p->p[i].y = coordinate(kind, seed);
}

static bool has_edge(const struct polygon *p, struct etch_point_s32 a, struct etch_point_s32 b)
{
    int i;

    for (i = 0; i < p->n; i++)
        if (same(p->p[i], a) && same(p->p[i + 1 < p->n ? i + 1 : 0], b))
            return true;
    return false;
}

/* What is left of each edge is an edge of the result, and everything lies in the rectangle. */
static void polygons_keep_their_edges(void)
{
    uint32_t seed = 2;
    int32_t n, edges = 0;

    for (n = 0; n < TEST_COUNT(60000) && !test_failed(); n++) {
        struct polygon in, out;
        struct etch_bounds r;
        int i;

        random_bounds(&r, n % 5, &seed);
        random_polygon(&in, n % 5, &seed);
        clip(&r, &in, &out);
        for (i = 0; i < out.n; i++)
            CHECK(out.p[i].x >= r.x0 && out.p[i].x <= r.x1 && out.p[i].y >= r.y0 &&
                  out.p[i].y <= r.y1);
        for (i = 0; i < in.n; i++) {
            struct etch_point_s32 e[2] = {in.p[i], in.p[i + 1 < in.n ? i + 1 : 0]};

            if (!etch_line_clip_liang_barsky(&r, e) || same(e[0], e[1]))
                continue;
            edges++;
            CHECK(has_edge(&out, e[0], e[1]));
        }
        if (test_failed())
            note(&r, in.p, in.n);
    }
    test_print_count("", edges, " edges of polygons, each cut like the line that it is");
}

/* How often the outline winds round (x + 1/2, y + 1/2); *odd: how often it is crossed, modulo 2.
 * Coordinates below 2^20. */
static int winding(const struct polygon *p, int32_t x, int32_t y, bool *odd)
{
    int i, turns = 0;

    *odd = false;
    for (i = 0; i < p->n; i++) {
        const struct etch_point_s32 a = p->p[i], b = p->p[i + 1 < p->n ? i + 1 : 0];
        const int64_t side = (int64_t)(b.x - a.x) * (2 * y + 1 - 2 * a.y) -
                             (int64_t)(b.y - a.y) * (2 * x + 1 - 2 * a.x);

        if ((a.y <= y) == (b.y <= y))
            continue;
        if ((side > 0) == (b.y > a.y)) /* crosses the row left of the point */
            turns += b.y > a.y ? 1 : -1, *odd = !*odd;
    }
    return turns;
}

/* Whether an edge of the polygon comes within `reach` units of the point, from which it is all the
 * same on which side of the edge it is. */
static bool is_near_edge(const struct polygon *p, int32_t x, int32_t y, int64_t reach)
{
    int i;

    for (i = 0; i < p->n; i++) {
        const struct etch_point_s32 a = p->p[i], b = p->p[i + 1 < p->n ? i + 1 : 0];
        const int64_t dx = b.x - a.x, dy = b.y - a.y;
        const int64_t side = dx * (2 * y + 1 - 2 * a.y) - dy * (2 * x + 1 - 2 * a.x);
        const int64_t span = size(dx) > size(dy) ? (int64_t)size(dx) : (int64_t)size(dy);

        if ((int64_t)size(side) <= 2 * reach * span + 1)
            return true;
    }
    return false;
}

/* Inside the rectangle a point further than a unit from each edge's line is enclosed as often by
 * the result as by the polygon, outside never. */
static void polygons_enclose_the_same(void)
{
    uint32_t seed = 3;
    int32_t n, points = 0;

    for (n = 0; n < TEST_COUNT(40000) && !test_failed(); n++) {
        struct polygon in, out;
        struct etch_bounds r;
        int k;

        random_bounds(&r, 3, &seed);
        random_polygon(&in, n % 2 == 0 ? 3 : 1, &seed);
        if (n % 4 == 1)
            random_bounds(&r, 1, &seed);
        clip(&r, &in, &out);
        for (k = 0; k < 8; k++) {
            const int32_t reach = n % 2 == 0 ? 70000 : 8;
            const int32_t x = test_range(&seed, -reach, reach);
            const int32_t y = test_range(&seed, -reach, reach);
            const bool inside = x >= r.x0 && x < r.x1 && y >= r.y0 && y < r.y1;
            bool odd, was_odd;
            const int turns = winding(&out, x, y, &odd), were = winding(&in, x, y, &was_odd);

            if (inside && is_near_edge(&in, x, y, 1))
                continue;
            points++;
            if (!CHECK_EQ(turns, inside ? were : 0) || !CHECK_EQ(odd, inside && was_odd)) {
                test_note("x", x);
                test_note("y", y);
                note(&r, in.p, in.n);
            }
        }
    }
    test_print_count("", points, " points, enclosed by what is left as by the polygon");
}

static void the_triangle_of_the_manual(void)
{
    const struct etch_bounds r = {0, 0, 10, 10};
    const struct polygon in = {3, {{5, -5}, {15, 5}, {5, 15}}};
    const struct etch_point_s32 expected[] = {{10, 0}, {10, 10}, {5, 10}, {5, 0}};
    struct polygon out;
    unsigned i;

    clip(&r, &in, &out);
    for (i = 0; i < sizeof expected / sizeof expected[0]; i++)
        CHECK(has_edge(&out, expected[i], expected[(i + 1) % 4]));
}

void suite_line_clip(void)
{
    RUN(lines_are_exact);
    RUN(the_triangle_of_the_manual);
    RUN(polygons_keep_their_edges);
    RUN(polygons_enclose_the_same);
}
