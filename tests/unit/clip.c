/* tests/unit: clipping against exact rational arithmetic.
 *
 * The oracle knows no order of planes: an exact corner is a point where two lines of the
 * triangle's plane (edges and clip planes) meet, inside all of them. Weights up to 2^62 times
 * numbers up to 2^58 make 128-bit sums. */
#include "core/vertex/clip.h"
#include "tests/harness/harness.h"
#include "tests/oracle/wide.h"

void suite_clip(void);

static int32_t triangles, corners, colors;

static const struct etch_rect rects[] = {
    {0, 0, 320, 240},     {0, 0, 240, 320},     {10, 20, 20, 23},
    {-100, -5, 500, 995}, {0, 0, 32767, 32767}, {-32768, -32768, 32767, 32767},
    {0, 0, 1, 1},         {5, 5, 69, 69},       {32000, 0, 32767, 10}};
#define RECTS ((int)(sizeof rects / sizeof rects[0]))

/* ---- the oracle ------------------------------------------------------------------------------ */

#define LINES 9
#define MOST_CORNERS 36

struct exact {
    int64_t line[LINES][3]; /* edges opposite to each vertex, then the planes */
    int n;
    struct exact_corner {
        uint64_t weight[3];
        int edge; /* 0 .. 2, or 3 inside */
    } corner[MOST_CORNERS];
};

/* The sum of weight[i] * v[i]: its sign, and its magnitude in *size. */
static int weighted(const uint64_t weight[3], const int64_t v[3], struct wide *size)
{
    struct wide plus = {0, 0}, minus = {0, 0};
    int i;

    for (i = 0; i < 3; i++) {
        const struct wide p = wide_product(weight[i], v[i] < 0 ? (uint64_t)-v[i] : (uint64_t)v[i]);

        if (v[i] < 0)
            minus = wide_sum(minus, p);
        else
            plus = wide_sum(plus, p);
    }
    *size = wide_distance(plus, minus);
    if (size->hi == 0 && size->lo == 0)
        return 0;
    return wide_at_most(minus, plus) ? 1 : -1;
}

static void set_lines(struct exact *e, const struct etch_viewport *viewport,
                      const struct etch_clip_vertex v[3])
{
    int i, j;

    for (j = 0; j < 3; j++) {
        const int64_t x = v[j].x, y = v[j].y, z = v[j].z, w = v[j].w;
        const int64_t wide = w * (INT64_C(1) << viewport->guard_x);
        const int64_t high = w * (INT64_C(1) << viewport->guard_y);
        const int64_t plane[6] = {w + z, w - z, wide + x, wide - x, high + y, high - y};

        for (i = 0; i < 3; i++)
            e->line[i][j] = i == j;
        for (i = 0; i < 6; i++)
            e->line[3 + i][j] = plane[i];
    }
}

/* The meeting point of two lines, if it is inside the triangle and all planes. */
static void add_corner(struct exact *e, int a, int b)
{
    const int64_t *p = e->line[a], *q = e->line[b];
    const int64_t cross[3] = {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2],
                              p[0] * q[1] - p[1] * q[0]};
    const bool flip = cross[0] < 0 || cross[1] < 0 || cross[2] < 0;
    struct exact_corner c = {{0, 0, 0}, a < 3 ? a : 3};
    struct wide size;
    int i;

    for (i = 0; i < 3; i++) {
        const int64_t w = flip ? -cross[i] : cross[i];

        if (w < 0)
            return;
        c.weight[i] = (uint64_t)w;
    }
    if (c.weight[0] == 0 && c.weight[1] == 0 && c.weight[2] == 0)
        return;
    for (i = 3; i < LINES; i++)
        if (weighted(c.weight, e->line[i], &size) < 0)
            return;
    e->corner[e->n++] = c;
}

/* All corners, or those on edges only, for which any clip coordinates fit. */
static void find_corners(struct exact *e, const struct etch_viewport *viewport,
                         const struct etch_clip_vertex v[3], bool inner)
{
    int a, b;

    e->n = 0;
    set_lines(e, viewport, v);
    for (a = 0; a < (inner ? LINES : 3); a++)
        for (b = a + 1; b < LINES; b++)
            add_corner(e, a, b);
}

/* Position on one axis within 1/64 + 1/512 px, the promise and the rounding: |P w - 128 (size v +
 * centre w)| <= 4.5 w, where v and w are the weighted sums. */
static bool is_near(int32_t position, const struct exact_corner *c, const int64_t v[3],
                    const int64_t w[3], int64_t size, int64_t centre)
{
    struct wide error, whole;
    int64_t twice[3];
    int i;

    for (i = 0; i < 3; i++)
        twice[i] = 2 * ((position - 128 * centre) * w[i] - 128 * size * v[i]);
    (void)weighted(c->weight, twice, &error);
    return weighted(c->weight, w, &whole) > 0 && wide_at_most(error, wide_scale(whole, 9));
}

static bool is_at(const struct etch_viewport *viewport, const struct etch_clip_vertex v[3],
                  const struct exact_corner *c, const struct etch_clip_vertex *got)
{
    const struct etch_rect r = viewport->rect;
    const int64_t x[3] = {v[0].x, v[1].x, v[2].x}, y[3] = {v[0].y, v[1].y, v[2].y};
    const int64_t w[3] = {v[0].w, v[1].w, v[2].w};
    struct etch_vertex p;

    etch_viewport_project(viewport, got, &p);
    return is_near(p.x_q8, c, x, w, r.x1 - r.x0, r.x0 + r.x1) &&
           is_near(p.y_q8, c, y, w, r.y0 - r.y1, r.y0 + r.y1);
}

/* A channel within 1/2 + 1/64: 64 |got whole - sum| <= 33 whole. */
static bool is_channel(uint8_t got, const struct exact_corner *c, uint8_t a, uint8_t b, uint8_t d)
{
    const int64_t error[3] = {64 * ((int64_t)got - a), 64 * ((int64_t)got - b),
                              64 * ((int64_t)got - d)};
    const int64_t most[3] = {33, 33, 33};
    struct wide size, whole;

    (void)weighted(c->weight, error, &size);
    (void)weighted(c->weight, most, &whole);
    return wide_at_most(size, whole);
}

static bool is_colored(const struct etch_clip_vertex v[3], const struct exact_corner *c,
                       const struct etch_clip_vertex *got)
{
    return is_channel(got->r, c, v[0].r, v[1].r, v[2].r) &&
           is_channel(got->g, c, v[0].g, v[1].g, v[2].g) &&
           is_channel(got->b, c, v[0].b, v[1].b, v[2].b) &&
           is_channel(got->a, c, v[0].a, v[1].a, v[2].a);
}

/* A corner with w = 0 is the eye itself: the triangle is edge-on and may be dropped. */
static bool sees_the_eye(const struct exact *e, const struct etch_clip_vertex v[3])
{
    const int64_t w[3] = {v[0].w, v[1].w, v[2].w};
    struct wide size;
    int i;

    for (i = 0; i < e->n; i++)
        if (weighted(e->corner[i].weight, w, &size) <= 0)
            return true;
    return false;
}

/* ---- input ----------------------------------------------------------------------------------- */

/* kind 0: anything; 1: small numbers; 2: ends and units; 3: a usual scene; 4: any size. */
static int32_t coordinate(int kind, int32_t most_bits, uint32_t *seed)
{
    static const int32_t ends[] = {INT32_MIN, INT32_MAX, -INT32_MAX, 0, 1, -1, 65536, -65536};
    const int32_t any = (int32_t)test_random(seed) >> (32 - most_bits);

    switch (kind) {
    case 0: return any;
    case 1: return test_range(seed, -8, 8);
    case 2: return most_bits == 32 ? ends[test_range(seed, 0, 7)] : test_range(seed, -2, 2) * 65536;
    case 3: return test_range(seed, -(INT32_C(1) << 18), INT32_C(1) << 18);
    default: return any >> test_range(seed, 0, most_bits - 1);
    }
}

static void random_vertex(struct etch_clip_vertex *v, int kind, int32_t bits, uint32_t *seed)
{
    const uint32_t color = test_random(seed);

    if (test_range(seed, 0, 9) == 0)
        kind = test_range(seed, 0, 4);
    v->x = coordinate(kind, bits, seed);
    v->y = coordinate(kind, bits, seed);
    v->z = coordinate(kind, bits, seed);
    v->w = coordinate(kind, bits, seed);
    if (v->w < 0 && v->w > INT32_MIN && test_range(seed, 0, 2) == 0)
        v->w = -v->w;
    v->r = (uint8_t)color;
    v->g = (uint8_t)(color >> 8);
    v->b = (uint8_t)(color >> 16);
    v->a = (uint8_t)(color >> 24);
}

static void note_triangle(const struct etch_clip_vertex v[3], struct etch_rect r)
{
    int i;

    test_note("viewport x0", r.x0);
    test_note("y0", r.y0);
    test_note("x1", r.x1);
    test_note("y1", r.y1);
    for (i = 0; i < 3; i++) {
        test_note("x", v[i].x);
        test_note("y", v[i].y);
        test_note("z", v[i].z);
        test_note("w", v[i].w);
    }
}

/* ---- cases ----------------------------------------------------------------------------------- */

/* Every exact corner is among the polygon's, and with `inner` also the other way round. */
static bool compare(const struct etch_viewport *viewport, const struct etch_clip_vertex v[3],
                    bool inner)
{
    struct etch_clip_vertex out[ETCH_CLIP_MAX];
    static struct exact exact;
    bool ok = true;
    int i, j, n;

    find_corners(&exact, viewport, v, inner);
    n = etch_clip_triangle(viewport, v, out);
    triangles++;
    ok = CHECK(n == 0 || (n >= 3 && n <= ETCH_CLIP_MAX));
    if (sees_the_eye(&exact, v))
        return ok;
    corners += exact.n;
    for (i = 0; i < exact.n && ok; i++) {
        for (j = 0; j < n && !is_at(viewport, v, &exact.corner[i], &out[j]); j++)
            ;
        ok = CHECK(j < n);
    }
    for (j = 0; j < n && inner && ok; j++) {
        struct etch_vertex p;

        for (i = 0; i < exact.n && !(is_at(viewport, v, &exact.corner[i], &out[j]) &&
                                     is_colored(v, &exact.corner[i], &out[j]));
             i++)
            ;
        ok = CHECK(i < exact.n);
        colors++;
        etch_viewport_project(viewport, &out[j], &p);
        CHECK(p.x_q8 >= -(INT32_C(1) << 23) && p.x_q8 <= INT32_C(1) << 23);
        CHECK(p.y_q8 >= -(INT32_C(1) << 23) && p.y_q8 <= INT32_C(1) << 23);
    }
    return ok;
}

static void compare_random(int32_t count, int32_t bits, uint32_t seed)
{
    int32_t n;

    for (n = 0; n < count && !test_failed(); n++) {
        const int kind = n % 5;
        struct etch_viewport viewport;
        struct etch_clip_vertex v[3];
        int i;

        (void)etch_viewport_init(&viewport, rects[n % RECTS]);
        for (i = 0; i < 3; i++)
            random_vertex(&v[i], kind, bits, &seed);
        if (!compare(&viewport, v, bits < 32))
            note_triangle(v, viewport.rect);
    }
}

/* Coordinates up to +-16.0, where the oracle knows all corners. */
static void polygons_are_exact(void)
{
    triangles = corners = colors = 0;
    compare_random(TEST_COUNT(100000), 21, 1);
    test_print_count("", triangles, " clipped triangles against exact rationals");
    test_print_count("", corners, " exact corners, each found within 1/64 px");
}

/* All of 16.16: the corners on edges. */
static void edges_are_exact_for_every_input(void)
{
    triangles = corners = 0;
    compare_random(TEST_COUNT(100000), 32, 2);
    test_print_count("", triangles, " clipped triangles of any size");
    test_print_count("", corners, " exact corners on their edges, each found within 1/64 px");
}

static bool same_vertex(const struct etch_clip_vertex *a, const struct etch_clip_vertex *b)
{
    return a->x == b->x && a->y == b->y && a->z == b->z && a->w == b->w && a->r == b->r &&
           a->g == b->g && a->b == b->b && a->a == b->a;
}

/* Two triangles with an edge in common, any order of vertices: each corner on that edge is the
 * same in both, bit for bit. */
static void shared_edges_stay_shared(void)
{
    static const uint8_t orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                         {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    uint32_t seed = 3;
    int32_t n, shared = 0;

    for (n = 0; n < TEST_COUNT(60000) && !test_failed(); n++) {
        const uint8_t *order = orders[test_range(&seed, 0, 5)];
        struct etch_viewport viewport;
        struct etch_clip_vertex v[4], other[3], out[ETCH_CLIP_MAX], next[ETCH_CLIP_MAX];
        static struct exact exact;
        int i, j, k, m, l;

        (void)etch_viewport_init(&viewport, rects[n % RECTS]);
        for (i = 0; i < 4; i++)
            random_vertex(&v[i], n % 5, 32, &seed);
        for (i = 0; i < 3; i++)
            other[i] = v[order[i] == 2 ? 3 : order[i]];
        m = etch_clip_triangle(&viewport, v, out);
        l = etch_clip_triangle(&viewport, other, next);
        if (m == 0 || l == 0)
            continue;
        find_corners(&exact, &viewport, v, false);
        for (i = 0; i < exact.n; i++) {
            bool found = exact.corner[i].edge != 2; /* the edge 0 1 is opposite to vertex 2 */

            for (j = 0; j < m && !found; j++)
                for (k = 0; k < l && !found; k++)
                    found = same_vertex(&out[j], &next[k]) &&
                            is_at(&viewport, v, &exact.corner[i], &out[j]);
            if (!CHECK(found))
                note_triangle(v, viewport.rect);
            shared += exact.corner[i].edge == 2;
        }
    }
    test_print_count("", shared, " corners on shared edges, equal bit for bit");
}

/* What lies inside comes back as it was, vertices and order. */
static void inside_is_untouched(void)
{
    uint32_t seed = 4;
    int32_t n, inside = 0;

    for (n = 0; n < TEST_COUNT(50000); n++) {
        struct etch_viewport viewport;
        struct etch_clip_vertex v[3], out[ETCH_CLIP_MAX];
        int i, bits = 0;

        (void)etch_viewport_init(&viewport, rects[n % RECTS]);
        for (i = 0; i < 3; i++) {
            random_vertex(&v[i], 3, 32, &seed);
            bits |= etch_viewport_outcode(&viewport, &v[i]);
        }
        if ((bits & ETCH_OUT_CLIP) != 0)
            continue;
        inside++;
        CHECK_EQ(etch_clip_triangle(&viewport, v, out), 3);
        for (i = 0; i < 3; i++)
            CHECK(same_vertex(&v[i], &out[i]));
    }
    CHECK(inside > TEST_COUNT(100));
}

void suite_clip(void)
{
    RUN(polygons_are_exact);
    RUN(edges_are_exact_for_every_input);
    RUN(shared_edges_stay_shared);
    RUN(inside_is_untouched);
}
