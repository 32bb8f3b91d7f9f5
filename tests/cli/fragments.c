/* tests/cli: random triangles, lines and points in random states, through scene files, against the
 * definition of the pipeline: colours within their bound, depths and stencil values exactly. Each
 * also in strips, which change nothing. */
#include <string.h>

#include "core/draw/line.h"
#include "fragments_sample.h"
#include "tests/harness/harness.h"
#include "tests/oracle/line.h"

void suite_fragments(void);

static struct fragments_sample sample;
static struct fragments_planes planes;
static int32_t doubtful, drawn;

static bool is_culled(const struct fragments_sample *s)
{
    const int64_t area = (int64_t)(s->x[1] - s->x[0]) * (s->y[2] - s->y[0]) -
                         (int64_t)(s->x[2] - s->x[0]) * (s->y[1] - s->y[0]);
    const bool clockwise = area > 0, front = clockwise == (s->front != 0);

    return s->cull == (front ? 2 : 1);
}

/* ---- what covers a pixel, and what becomes of it -----------------------------------------------
 */

/* The triangles that a sample is drawn as: vertex i of each is vertex from[i] of the sample. */
struct shape {
    struct oracle_triangle t[2];
    struct oracle_vertex v[2][3];
    struct oracle_state state; /* as it is for this kind: lines have neither texture nor w */
    int n;
};

static void make_triangle(struct shape *shape, const struct fragments_sample *s)
{
    int32_t xs[3], ys[3];

    for (int i = 0; i < 3; i++)
        xs[i] = s->x[i] * 16, ys[i] = s->y[i] * 16;
    shape->n = is_culled(s) ? 0 : 1;
    oracle_triangle_make(&shape->t[0], xs, ys);
    memcpy(shape->v[0], s->vertex, sizeof s->vertex);
}

/* The corners are those of etch_line_wide, which the suite line_wide proves. */
static void make_wide(struct shape *shape, const struct fragments_sample *s)
{
    static const int from[2][3] = {{0, 1, 2}, {0, 2, 3}}, end[4] = {0, 1, 1, 0};
    const struct etch_vertex v[2] = {{.x_q8 = s->x[0] * 16, .y_q8 = s->y[0] * 16},
                                     {.x_q8 = s->x[1] * 16, .y_q8 = s->y[1] * 16}};
    const struct etch_vertex *const ends[2] = {&v[0], &v[1]};
    struct etch_vertex corner[4];

    shape->n = etch_line_wide_corners(corner, ends, (uint16_t)(s->size * 16)) ? 2 : 0;
    for (int k = 0; k < shape->n; k++) {
        int32_t xs[3], ys[3];

        for (int i = 0; i < 3; i++) {
            xs[i] = corner[from[k][i]].x_q8, ys[i] = corner[from[k][i]].y_q8;
            shape->v[k][i] = s->vertex[end[from[k][i]]];
            shape->v[k][i].w = 1;
        }
        oracle_triangle_make(&shape->t[k], xs, ys);
    }
}

static void make_shape(struct shape *shape, const struct fragments_sample *s)
{
    shape->state = s->state;
    shape->n = 0;
    if (s->kind == FRAGMENTS_TRI)
        make_triangle(shape, s);
    else
        shape->state.tex = 0;
    if (s->kind == FRAGMENTS_WIDE)
        make_wide(shape, s);
}

/* Whether the point covers the pixel: by its centre, both in 1/32 px against it. */
static bool point_covers(const struct fragments_sample *s, int x, int y)
{
    const int dx = 2 * (16 * x + 8 - s->x[0]), dy = 2 * (16 * y + 8 - s->y[0]);

    if (s->kind == FRAGMENTS_ROUND)
        return dx * dx + dy * dy <= s->size * s->size;
    return dx >= -s->size && dx < s->size && dy >= -s->size && dy < s->size;
}

static void line_fragment(struct oracle_fragment *f, const struct fragments_sample *s,
                          const struct oracle_state *state, int x, int y)
{
    const int p[4] = {s->x[0] >> 4, s->y[0] >> 4, s->x[1] >> 4, s->y[1] >> 4};
    const int dx = p[2] - p[0], dy = p[3] - p[1];
    const int across = dx < 0 ? -dx : dx, down = dy < 0 ? -dy : dy;
    const int k = down > across ? y - p[1] : x - p[0];

    if (oracle_line_covers(p[0], p[1], p[2], p[3], x, y))
        oracle_line_fragment(f, state, s->vertex, k < 0 ? -k : k, down > across ? down : across,
                             s->before[y * FRAGMENTS_WIDTH + x]);
}

/* What becomes of a pixel. */
static void expect(struct oracle_fragment *f, const struct fragments_sample *s,
                   const struct shape *shape, int x, int y)
{
    const struct oracle_pixel before = s->before[y * FRAGMENTS_WIDTH + x];
    const struct oracle_vertex same[2] = {s->vertex[0], s->vertex[0]};

    *f = (struct oracle_fragment){.pixel = before};
    if (!fragments_is_inside(s, x, y))
        return;
    for (int i = 0; i < shape->n; i++)
        if (oracle_triangle_covers(&shape->t[i], x, y))
            oracle_fragment(f, &shape->state, &shape->t[i], shape->v[i], x, y, before);
    if (s->kind == FRAGMENTS_LINE)
        line_fragment(f, s, &shape->state, x, y);
    if ((s->kind == FRAGMENTS_SQUARE || s->kind == FRAGMENTS_ROUND) && point_covers(s, x, y))
        oracle_line_fragment(f, &shape->state, same, 0, 0, before);
}

/* ---- comparing ---------------------------------------------------------------------------------
 */

static void note(const struct fragments_sample *s, int x, int y, const struct oracle_fragment *f)
{
    fragments_keep(s);
    test_note("x", x);
    test_note("y", y);
    test_note("red", f->channel[0]);
    test_note("green", f->channel[1]);
    test_note("blue", f->channel[2]);
}

static void compare(const struct fragments_sample *s)
{
    const bool deep = s->state.ztest != 0 || s->state.stencil != 0;
    struct shape shape;

    make_shape(&shape, s);
    for (int i = 0; i < FRAGMENTS_PIXELS && !test_failed(); i++) {
        const int x = i % FRAGMENTS_WIDTH, y = i / FRAGMENTS_WIDTH;
        const uint16_t got = planes.color[i];
        const uint16_t color = (uint16_t)(s->swapped ? (got << 8 | got >> 8) & 0xFFFF : got);
        struct oracle_fragment f;

        expect(&f, s, &shape, x, y);
        doubtful += f.doubtful;
        drawn += f.drawn && !f.doubtful;
        if (f.doubtful)
            continue;
        /* 1/64 of a step, and what fog errs by */
        if (!CHECK(oracle_fragment_color_ok(&f, &s->state, s->before[i], color,
                                            ORACLE_ONE / (s->state.fog != 0 ? 48 : 64))) ||
            (deep && (!CHECK_EQ(planes.depth[i], f.pixel.depth) ||
                      !CHECK_EQ(planes.stencil[i], f.pixel.stencil))))
            note(s, x, y, &f);
    }
}

static bool is_same(const struct fragments_planes *a, const struct fragments_planes *b)
{
    return memcmp(a->color, b->color, sizeof a->color) == 0 &&
           memcmp(a->depth, b->depth, sizeof a->depth) == 0 &&
           memcmp(a->stencil, b->stencil, sizeof a->stencil) == 0;
}

static void try_kind(enum fragments_kind kind, uint32_t *seed, int32_t i)
{
    static struct fragments_planes whole;

    fragments_make(&sample, kind, seed);
    if (!fragments_draw(&sample, FRAGMENTS_HEIGHT, &planes))
        return;
    compare(&sample);
    whole = planes;
    if (i % 4 == 0 && fragments_draw(&sample, 1 + i / 4 % 6, &planes) &&
        !CHECK(is_same(&whole, &planes)))
        fragments_keep(&sample);
}

static void triangles_are_their_definition(void)
{
    uint32_t seed = 97;

    for (int32_t i = 0; i < TEST_COUNT(1500) && !test_failed(); i++)
        try_kind(FRAGMENTS_TRI, &seed, i);
    CHECK(doubtful * 4 < drawn);
}

static void lines_and_points_are_theirs(void)
{
    uint32_t seed = 98;

    for (int32_t i = 0; i < TEST_COUNT(1500) && !test_failed(); i++)
        try_kind(FRAGMENTS_LINE + (enum fragments_kind)(i / 4 % (FRAGMENTS_KINDS - 1)), &seed, i);
    CHECK(doubtful * 4 < drawn);
}

void suite_fragments(void)
{
    doubtful = drawn = 0;
    RUN(triangles_are_their_definition);
    test_print_count("", drawn, " fragments drawn in random states, as the pipeline defines them");
    test_print_count("", doubtful, " decided by less than their bound, not compared");
    doubtful = drawn = 0;
    RUN(lines_and_points_are_theirs);
    test_print_count("", drawn, " fragments of lines and points in random states, likewise");
    test_print_count("", doubtful, " decided by less than their bound, not compared");
}
