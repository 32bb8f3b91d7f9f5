/* tests/unit: the sources of staged pixel work keep their bounds against exact rationals: colour
 * and alpha, linear on the screen and in perspective. */
#include "core/draw/staged.h"
#include "core/fragment/write.h"
#include "tests/harness/canvas.h"
#include "tests/harness/sample.h"
#include "tests/oracle/texture.h"

void suite_staged_sources(void);

static struct test_canvas canvas;
static struct etch_staged_planes planes;

#define END                                                                                        \
    {                                                                                              \
        NULL, NULL                                                                                 \
    }

static void random_alpha(struct test_sample *s, uint32_t *seed)
{
    const int kind = test_range(seed, 0, 2);
    int k;

    for (k = 0; k < 3; k++)
        s->vertex[k].a = (uint8_t)(kind == 0   ? test_range(seed, 0, 255)
                                   : kind == 1 ? 255 * test_range(seed, 0, 1)
                                               : 17);
}

/* ---- bounds of the sources: a stage that keeps what it sees
 * -------------------------------------- */

static struct {
    uint16_t value[4];
    int32_t u, v;
} seen[48][64];

static void keep(struct etch_chunk *c, const void *data)
{
    const struct etch_surface *s = c->surface;
    uint16_t i;

    (void)data;
    for (i = 0; i < c->n; i++) {
        const int32_t x = c->x + i - s->window.x0, y = c->y - s->window.y0;

        CHECK((c->x + i) / ETCH_CHUNK == c->x / ETCH_CHUNK && (c->alive >> i & 1) != 0);
        CHECK_EQ(c->first + i, etch_surface_index(s, (int16_t)(c->x + i), c->y));
        seen[y][x].value[0] = c->r[i];
        seen[y][x].value[1] = c->g[i];
        seen[y][x].value[2] = c->b[i];
        seen[y][x].value[3] = c->a[i];
        s->pixels[c->first + i] = TEST_INK;
    }
}

static etch_varying *const linear[] = {etch_varying_color, etch_varying_alpha, NULL};
static const struct etch_stage linear_kept[] = {
    {etch_source_color, NULL}, {etch_source_alpha, NULL}, {keep, NULL}, END};
static etch_varying *const perspective[] = {etch_varying_color_perspective, NULL};
static const struct etch_stage perspective_kept[] = {
    {etch_source_color_perspective, NULL}, {keep, NULL}, END};

static int32_t worst[2][4]; /* 2^-20 of full, above what the format rounds */

/* |got - exact| in 2^-20 of full: exact from the oracle as 8.22. */
static int64_t error_of(uint16_t got, uint32_t full, uint64_t exact)
{
    const int64_t want = (int64_t)(exact - (UINT64_C(1) << 31)); /* 255 2^22 is full */
    const int64_t mine = (int64_t)got * 255 * (INT64_C(1) << 22) / (int64_t)full;
    const int64_t off = (mine - want) / (255 << 2);

    return off < 0 ? -off : off;
}

/* Red, green, blue and alpha of every pixel: 31 2^11 of full is 1/63488, 16.5 of 2^-20, and so on.
 * A format that is cut is off by up to a unit, one that is rounded by half. */
static void check_values(const struct test_sample *s, const uint32_t w[3], bool rounded)
{
    static const uint32_t full[4] = {31 << 11, 63 << 10, 31 << 11, 255 << 8};
    const struct etch_rect c = canvas.surface.window;
    int32_t x, y;
    int k;

    for (y = c.y0; y < c.y1; y++) {
        for (x = c.x0; x < c.x1; x++) {
            if (!oracle_triangle_covers(&s->exact, x, y)) {
                CHECK_EQ(test_canvas_at(&canvas, x, y), TEST_BACKGROUND);
                continue;
            }
            for (k = 0; k < 4; k++) {
                const struct etch_vertex *v = s->vertex;
                const int32_t value[3] = {(k == 0   ? v[0].r
                                           : k == 1 ? v[0].g
                                           : k == 2 ? v[0].b
                                                    : v[0].a)
                                              << 22,
                                          (k == 0   ? v[1].r
                                           : k == 1 ? v[1].g
                                           : k == 2 ? v[1].b
                                                    : v[1].a)
                                              << 22,
                                          (k == 0   ? v[2].r
                                           : k == 1 ? v[2].g
                                           : k == 2 ? v[2].b
                                                    : v[2].a)
                                              << 22};
                const uint64_t exact = oracle_texture(&s->exact, x, y, value, w, 0);
                const int64_t off = error_of(seen[y - c.y0][x - c.x0].value[k], full[k], exact);
                /* of a step of 2^20 / 31 or 63: 1/64 is 528 or 260; alpha: 1/512 + 1/512 is 16 */
                const int64_t allowed = k == 3 ? 16 + 1 : k == 1 ? 260 : 528;

                if (off > worst[rounded][k])
                    worst[rounded][k] = (int32_t)off;
                if (!CHECK(off <= allowed)) {
                    test_sample_note(s, x, y);
                    test_note("channel", k);
                    test_note("w0", w != NULL ? w[0] : 0);
                    test_note("w1", w != NULL ? w[1] : 0);
                    test_note("w2", w != NULL ? w[2] : 0);
                    return;
                }
            }
        }
    }
}

static void linear_sources_keep_their_bounds(void)
{
    static const struct etch_pipeline kept = {linear, linear_kept, etch_kernel_staged};
    uint32_t seed = 63;
    int32_t i;

    for (i = 0; i < TEST_COUNT(700) && !test_failed(); i++) {
        struct test_sample s;
        const struct etch_vertex *const v[3] = {&s.vertex[0], &s.vertex[1], &s.vertex[2]};

        test_sample_make(&s, &canvas, i, &seed);
        if (canvas.surface.window.x0 > 2000) /* alpha drifts beyond; see source.h */
            continue;
        random_alpha(&s, &seed);
        etch_triangle_staged(&canvas.surface, v, &kept, &planes);
        check_values(&s, NULL, false);
    }
}

/* Any w, ratios up to 1 : 65535, every kind of triangle, all over the plane. */
static void perspective_sources_keep_their_bounds(void)
{
    static const struct etch_pipeline kept = {perspective, perspective_kept, etch_kernel_staged};
    uint32_t seed = 64;
    int32_t i;

    for (i = 0; i < TEST_COUNT(700) && !test_failed(); i++) {
        struct test_sample s;
        struct etch_texture_vertex t[3];
        const struct etch_vertex *const v[3] = {&t[0].at, &t[1].at, &t[2].at};
        const int kind = test_range(&seed, 0, 3);
        uint32_t w[3];
        int k;

        test_sample_make(&s, &canvas, i, &seed);
        random_alpha(&s, &seed);
        for (k = 0; k < 3; k++) {
            w[k] = (uint32_t)(kind == 0   ? test_range(&seed, 1, 65535)
                              : kind == 1 ? 65534 * test_range(&seed, 0, 1) + 1
                              : kind == 2 ? test_range(&seed, 60000, 65535)
                                          : 1 << test_range(&seed, 0, 15));
            t[k].at = s.vertex[k];
            t[k].u = t[k].v = 0;
            t[k].w = w[k] << (i % 3 * 8);
        }
        etch_triangle_staged(&canvas.surface, v, &kept, &planes);
        check_values(&s, w, true);
    }
}

/* Never outside what the vertices span once rounded, and equal colours stay equal, for all w. */
static void perspective_stays_between_the_vertices(void)
{
    static const struct etch_stage written[] = {
        {etch_source_color_perspective, NULL}, {etch_stage_write, NULL}, END};
    static const struct etch_pipeline pipeline = {perspective, written, etch_kernel_staged};
    uint32_t seed = 65;
    int32_t i, x, y;

    for (i = 0; i < TEST_COUNT(1500) && !test_failed(); i++) {
        struct test_sample s;
        struct etch_texture_vertex t[3];
        const struct etch_vertex *const v[3] = {&t[0].at, &t[1].at, &t[2].at};
        uint16_t least[3] = {63, 63, 63}, most[3] = {0, 0, 0};
        const struct etch_rect *c = &canvas.surface.window;
        uint32_t hash;
        int k, n;

        test_sample_make(&s, &canvas, i, &seed);
        for (k = 0; k < 3; k++) {
            const uint32_t w = test_random(&seed);
            const struct etch_vertex *q = &s.vertex[k];
            const uint16_t color = (uint16_t)((2 * 31 * q->r + 255) / 510 << 11 |
                                              (2 * 63 * q->g + 255) / 510 << 5 |
                                              (2 * 31 * q->b + 255) / 510);

            t[k].at = *q;
            t[k].u = t[k].v = 0;
            t[k].w = w >> test_range(&seed, 0, 31);
            for (n = 0; n < 3; n++) {
                const uint16_t value = (uint16_t)(n == 0   ? color >> 11
                                                  : n == 1 ? color >> 5 & 63
                                                           : color & 31);

                least[n] = value < least[n] ? value : least[n];
                most[n] = value > most[n] ? value : most[n];
            }
        }
        etch_triangle_staged(&canvas.surface, v, &pipeline, &planes);
        for (y = c->y0; y < c->y1; y++) {
            for (x = c->x0; x < c->x1; x++) {
                const uint16_t p = test_canvas_at(&canvas, x, y);

                if (oracle_triangle_covers(&s.exact, x, y) &&
                    !CHECK(p >> 11 >= least[0] && p >> 11 <= most[0] && (p >> 5 & 63) >= least[1] &&
                           (p >> 5 & 63) <= most[1] && (p & 31) >= least[2] && (p & 31) <= most[2]))
                    test_sample_note(&s, x, y);
            }
        }
        hash = test_canvas_hash(&canvas);
        for (k = 1; k < 6; k++) { /* the order of the vertices changes no value */
            const struct etch_vertex *const other[3] = {v[test_orders[k][0]], v[test_orders[k][1]],
                                                        v[test_orders[k][2]]};

            test_canvas_wipe(&canvas);
            etch_triangle_staged(&canvas.surface, other, &pipeline, &planes);
            CHECK_EQ(test_canvas_hash(&canvas), hash);
        }
    }
}

static void print_worst(int rounded, const char *label)
{
    test_print_count(
        label,
        (worst[rounded][0] > worst[rounded][2] ? worst[rounded][0] : worst[rounded][2]) * 31 / 256,
        "/4096 step before rounding, allowed 64");
}

void suite_staged_sources(void)
{
    RUN(linear_sources_keep_their_bounds);
    RUN(perspective_sources_keep_their_bounds);
    RUN(perspective_stays_between_the_vertices);
    print_worst(0, "largest error of linear red and blue ");
    print_worst(1, "largest error of red and blue in perspective ");
}
