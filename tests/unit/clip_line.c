/* tests/unit: lines in clip space against exact rational arithmetic, and against the triangle
 * clipper, whose corners on a shared edge they must be. */
#include "core/vertex/clip.h"
#include "core/vertex/clip_line.h"
#include "tests/harness/harness.h"
#include "tests/oracle/wide.h"
#include "tests/unit/clip_parts.h"

void suite_clip_line(void);

static const struct etch_rect rects[] = {{0, 0, 320, 240},     {10, 20, 20, 23},
                                         {0, 0, 32767, 32767}, {-32768, -32768, 32767, 32767},
                                         {0, 0, 1, 1},         {32000, 0, 32767, 10}};
#define RECTS ((int)(sizeof rects / sizeof rects[0]))

/* ---- the oracle: every plane as an interval of t, the latest beginning and the earliest end ---
 */

/* t = n / d, 0 < n <= d < 2^44 */
struct fraction {
    uint64_t n, d;
};

struct exact {
    bool empty, cut[2];
    struct fraction from, to;
};

static int compare(struct fraction a, struct fraction b)
{
    const struct wide x = wide_product(a.n, b.d), y = wide_product(b.n, a.d);

    return !wide_at_most(x, y) ? 1 : wide_at_most(y, x) ? 0 : -1;
}

static void exact_plane(struct exact *e, int64_t d0, int64_t d1)
{
    const bool in0 = d0 >= 0, in1 = d1 >= 0;
    struct fraction t;

    if (in0 && in1)
        return;
    if (!in0 && !in1) {
        e->empty = true;
        return;
    }
    t.n = (uint64_t)(in0 ? d0 : -d0);
    t.d = t.n + (uint64_t)(in1 ? d1 : -d1);
    if (in0 && (!e->cut[1] || compare(t, e->to) < 0))
        e->to = t, e->cut[1] = true;
    if (in1 && (!e->cut[0] || compare(t, e->from) > 0))
        e->from = t, e->cut[0] = true;
}

static struct exact exact_line(const struct etch_clip_vertex v[2], uint8_t shift_x, uint8_t shift_y)
{
    struct exact e = {false, {false, false}, {0, 1}, {1, 1}};
    int64_t d[6][2];
    int i;

    for (i = 0; i < 2; i++) {
        const int64_t w = v[i].w, wide = w * (INT64_C(1) << shift_x);
        const int64_t high = w * (INT64_C(1) << shift_y);

        d[0][i] = w + v[i].z, d[1][i] = w - v[i].z;
        d[2][i] = wide + v[i].x, d[3][i] = wide - v[i].x;
        d[4][i] = high + v[i].y, d[5][i] = high - v[i].y;
    }
    for (i = 0; i < 6; i++)
        exact_plane(&e, d[i][0], d[i][1]);
    if (compare(e.from, e.to) > 0)
        e.empty = true;
    return e;
}

/* a (d - n) + b n: the coordinate at t, times d. */
static void at(const struct fraction t, int64_t a, int64_t b, uint64_t k, struct wide *plus,
               struct wide *minus)
{
    const struct wide zero = {0, 0};
    const uint64_t weight[2] = {t.d - t.n, t.n};
    const int64_t v[2] = {a, b};
    int i;

    *plus = *minus = zero;
    for (i = 0; i < 2; i++) {
        const struct wide p = wide_scale(
            wide_product(weight[i], v[i] < 0 ? (uint64_t)-v[i] : (uint64_t)v[i]), (uint32_t)k);

        *(v[i] < 0 ? minus : plus) = wide_sum(*(v[i] < 0 ? minus : plus), p);
    }
}

/* 2 |position w - 128 (size c + centre w)| <= 9 w, all at t: within 1/64 + 1/512 px. */
static bool is_near(int32_t position, struct fraction t, const int64_t c[2], const int64_t w[2],
                    int64_t size, int64_t centre)
{
    struct wide plus, minus, whole, none;
    int64_t error[2];
    int i;

    for (i = 0; i < 2; i++)
        error[i] = (position - 128 * centre) * w[i] - 128 * size * c[i];
    at(t, error[0], error[1], 2, &plus, &minus);
    at(t, w[0], w[1], 9, &whole, &none);
    return wide_at_most(none, whole) &&
           wide_at_most(wide_distance(plus, minus), wide_distance(whole, none));
}

static bool is_at(const struct etch_viewport *viewport, const struct etch_clip_vertex v[2],
                  struct fraction t, const struct etch_clip_vertex *got)
{
    const struct etch_rect r = viewport->rect;
    const int64_t x[2] = {v[0].x, v[1].x}, y[2] = {v[0].y, v[1].y}, w[2] = {v[0].w, v[1].w};
    struct etch_vertex p;

    etch_viewport_project(viewport, got, &p);
    return is_near(p.x_q8, t, x, w, r.x1 - r.x0, r.x0 + r.x1) &&
           is_near(p.y_q8, t, y, w, r.y0 - r.y1, r.y0 + r.y1);
}

/* 64 |got - exact| <= 33: within 1/2 + 1/64. */
static bool is_channel(uint8_t got, struct fraction t, uint8_t a, uint8_t b)
{
    const int64_t error = 64 * (((int64_t)got - a) * (int64_t)(t.d - t.n) +
                                ((int64_t)got - b) * (int64_t)t.n);

    return (error < 0 ? -error : error) <= 33 * (int64_t)t.d;
}

/* ---- input ----------------------------------------------------------------------------------- */

static void note_line(const struct etch_clip_vertex v[2])
{
    int i;

    for (i = 0; i < 2; i++) {
        test_note("x", v[i].x);
        test_note("y", v[i].y);
        test_note("z", v[i].z);
        test_note("w", v[i].w);
    }
}

/* ---- cases ----------------------------------------------------------------------------------- */

/* True if the cut is where w = 0: the eye, of which nothing is promised. */
static bool is_eye(const struct etch_clip_vertex v[2], struct fraction t)
{
    struct wide plus, minus;

    at(t, v[0].w, v[1].w, 1, &plus, &minus);
    return wide_at_most(plus, minus);
}

static bool check_end(const struct etch_viewport *viewport, const struct etch_clip_vertex v[2],
                      const struct exact *e, int end, const struct etch_clip_vertex *got)
{
    const struct fraction t = end == 0 ? e->from : e->to;

    if (!e->cut[end])
        return CHECK(same_vertex(got, &v[end]));
    return CHECK(is_channel(got->r, t, v[0].r, v[1].r)) &&
           CHECK(is_channel(got->g, t, v[0].g, v[1].g)) &&
           CHECK(is_channel(got->b, t, v[0].b, v[1].b)) &&
           CHECK(is_channel(got->a, t, v[0].a, v[1].a)) && CHECK(is_at(viewport, v, t, got));
}

static int32_t kept;

/* One clipper, forth and back. */
static bool try_line(const struct etch_viewport *viewport, const struct etch_clip_vertex v[2],
                     bool volume)
{
    const struct exact e = exact_line(v, volume ? 0 : viewport->guard_x,
                                      volume ? 0 : viewport->guard_y);
    const struct etch_clip_vertex back[2] = {v[1], v[0]};
    struct etch_clip_vertex out[2], turned[2];
    const bool got = volume ? etch_clip_line_volume(v, out) : etch_clip_line(viewport, v, out);
    const bool again = volume ? etch_clip_line_volume(back, turned)
                              : etch_clip_line(viewport, back, turned);

    if (!CHECK_EQ(got, again))
        return false;
    if (e.empty)
        return CHECK(!got);
    if (is_eye(v, e.from) || is_eye(v, e.to))
        return true;
    kept++;
    return CHECK(got) && CHECK(same_vertex(&out[0], &turned[1])) &&
           CHECK(same_vertex(&out[1], &turned[0])) && check_end(viewport, v, &e, 0, &out[0]) &&
           check_end(viewport, v, &e, 1, &out[1]);
}

static void lines_are_exact(void)
{
    uint32_t seed = 1;
    int32_t n;

    kept = 0;
    for (n = 0; n < TEST_COUNT(100000) && !test_failed(); n++) {
        struct etch_viewport viewport;
        struct etch_clip_vertex v[2];
        const int kind = n % 5;

        (void)etch_viewport_init(&viewport, rects[n % RECTS]);
        random_vertex(&v[0], kind, &seed);
        random_vertex(&v[1], test_range(&seed, 0, 9) == 0 ? 4 : kind, &seed);
        if (!try_line(&viewport, v, false) || !try_line(&viewport, v, true))
            note_line(v);
    }
    CHECK(kept > TEST_COUNT(50000));
    test_print_count("", kept, " clipped lines of any size, each end within 1/64 px");
}

/* What is left in the volume lies in the viewport's rectangle, edges included. */
static void volume_is_the_viewport(void)
{
    uint32_t seed = 2;
    int32_t n;

    for (n = 0; n < TEST_COUNT(50000) && !test_failed(); n++) {
        const struct etch_rect r = rects[n % RECTS];
        struct etch_viewport viewport;
        struct etch_clip_vertex v[2], out[2];
        int i;

        (void)etch_viewport_init(&viewport, r);
        random_vertex(&v[0], n % 5, &seed);
        random_vertex(&v[1], n % 5, &seed);
        if (!etch_clip_line_volume(v, out))
            continue;
        for (i = 0; i < 2; i++) {
            struct etch_vertex p;

            etch_viewport_project(&viewport, &out[i], &p);
            if (!CHECK(p.x_q8 >= r.x0 * 256 && p.x_q8 <= r.x1 * 256 && p.y_q8 >= r.y0 * 256 &&
                       p.y_q8 <= r.y1 * 256))
                note_line(v);
        }
    }
}

/* Each end that is left of an edge is a corner of every clipped triangle with that edge. */
static void edges_are_those_of_triangles(void)
{
    uint32_t seed = 3;
    int32_t n, shared = 0;

    for (n = 0; n < TEST_COUNT(50000) && !test_failed(); n++) {
        struct etch_viewport viewport;
        struct etch_clip_vertex v[3], polygon[ETCH_CLIP_MAX], out[2];
        int i, k, corners;

        (void)etch_viewport_init(&viewport, rects[n % RECTS]);
        for (i = 0; i < 3; i++)
            random_vertex(&v[i], n % 5, &seed);
        corners = etch_clip_triangle(&viewport, v, polygon);
        if (corners == 0 || !etch_clip_line(&viewport, v, out))
            continue;
        for (i = 0; i < 2; i++) {
            for (k = 0; k < corners && !same_vertex(&polygon[k], &out[i]); k++)
                ;
            if (!CHECK(k < corners))
                note_line(v);
            shared++;
        }
    }
    test_print_count("", shared, " ends of edges, each a corner of its triangle bit for bit");
}

void suite_clip_line(void)
{
    RUN(lines_are_exact);
    RUN(volume_is_the_viewport);
    RUN(edges_are_those_of_triangles);
}
