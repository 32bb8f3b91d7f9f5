/* tests/unit: thick polylines against distances from the line, and their caps, joints and dashes.
 */
#include "core/raster/stroke.h"
#include "tests/harness/canvas.h"

void suite_stroke(void);

enum {
    W = 24,
    H = 20,
    EDGES = 2000
};

static struct etch_smooth_edge edges[EDGES];
static struct etch_smooth smooth;
static const struct etch_outline to_smooth = {etch_outline_smooth, &smooth};
static int16_t row_memory[W + 1];
static int32_t covers[H][W];

static void keep(const struct etch_surface *s, int16_t x, int16_t y, uint16_t n,
                 const int16_t *cover, const struct etch_cover_paint *paint)
{
    (void)s, (void)paint;
    for (uint16_t i = 0; i < n; i++)
        covers[y][x + i] += cover[i];
}

static void start(void)
{
    etch_smooth_init(&smooth, edges, EDGES);
}

static void fill(void)
{
    static const struct etch_cover_paint paint = {keep};
    static uint16_t pixels[W * H];
    struct etch_surface surface;

    for (int32_t i = 0; i < W * H; i++)
        covers[i / W][i % W] = 0;
    CHECK_EQ(smooth.status, ETCH_OK);
    CHECK_EQ(etch_surface_init(&surface, pixels, (struct etch_rect){0, 0, W, H}, W), ETCH_OK);
    etch_smooth_fill_nonzero(&surface, &smooth, &paint, row_memory);
}

/* Whether (x, y) is within `half` of the segment from a to b; with flat ends, or ends `more`
 * longer. */
static bool near(struct etch_point_q8 a, struct etch_point_q8 b, int64_t x, int64_t y, int64_t half)
{
    const int64_t dx = b.x - a.x, dy = b.y - a.y, px = x - a.x, py = y - a.y;
    const int64_t dot = dx * px + dy * py, square = dx * dx + dy * dy, cross = dx * py - dy * px;

    if (dot <= 0)
        return px * px + py * py <= half * half;
    if (dot >= square)
        return (x - b.x) * (x - b.x) + (y - b.y) * (y - b.y) <= half * half;
    return cross * cross <= half * half * square;
}

static bool in_butt(struct etch_point_q8 a, struct etch_point_q8 b, int64_t x, int64_t y,
                    int64_t half, int64_t more)
{
    const int64_t dx = b.x - a.x, dy = b.y - a.y, px = x - a.x, py = y - a.y;
    const int64_t dot = dx * px + dy * py, square = dx * dx + dy * dy, cross = dx * py - dy * px;
    const int64_t before = dot < 0 ? -dot : 0, after = dot > square ? dot - square : 0;

    return cross * cross <= half * half * square && before * before <= more * more * square &&
           after * after <= more * more * square;
}

/* Points within half the width of the line, at 1/32 px: what round caps and joints make. */
static void round_strokes_are_distances(void)
{
    uint32_t seed = 1;

    for (int32_t i = 0; i < TEST_COUNT(40) && !test_failed(); i++) {
        const int32_t width = 2 * test_range(&seed, 64, 1000);
        const struct etch_stroke s = {width, etch_cap_round, etch_join_round, 1024};
        const uint16_t n = (uint16_t)test_range(&seed, 2, 4);
        const bool closed = n > 2 && i % 3 == 0;
        struct etch_point_q8 v[5];
        int32_t wrong = 0, worst = 0;

        for (uint16_t k = 0; k < n; k++) {
            v[k].x = test_range(&seed, -600, 256 * W + 600);
            v[k].y = test_range(&seed, -600, 256 * H + 600);
        }
        v[n] = v[0];
        start();
        etch_stroke_outline(&to_smooth, v, n, closed, &s);
        fill();
        for (int32_t p = 0; p < W * H; p++) {
            int32_t inside = 0;

            for (int32_t q = 0; q < 1024; q++) {
                bool in = false;

                for (uint16_t k = 1; k < n + (closed ? 1 : 0); k++)
                    in = in || near(v[k - 1], v[k], p % W * 256 + q % 32 * 8 + 4,
                                    p / W * 256 + q / 32 * 8 + 4, width / 2);
                inside += in;
            }
            inside = 4 * inside - covers[p / W][p % W];
            worst = inside > worst ? inside : -inside > worst ? -inside : worst;
            wrong += inside > 384 || inside < -384; /* 1/16, and what samples err */
        }
        if (!CHECK_EQ(wrong, 0))
            test_note("stroke", i), test_note("worst", worst);
    }
}

static void butt_and_square_ends(void)
{
    uint32_t seed = 2;

    for (int32_t i = 0; i < TEST_COUNT(60) && !test_failed(); i++) {
        const int32_t width = 2 * test_range(&seed, 64, 1000);
        const bool square = i % 2 != 0;
        const struct etch_stroke s = {width, square ? etch_cap_square : etch_cap_butt,
                                      etch_join_bevel, 1024};
        const struct etch_point_q8 v[2] = {
            {test_range(&seed, 0, 256 * W), test_range(&seed, 0, 256 * H)},
            {test_range(&seed, 0, 256 * W), test_range(&seed, 0, 256 * H)}};
        int32_t wrong = 0;

        if (v[0].x == v[1].x && v[0].y == v[1].y)
            continue;
        start();
        etch_stroke_outline(&to_smooth, v, 2, false, &s);
        fill();
        for (int32_t p = 0; p < W * H; p++) {
            int32_t inside = 0;

            for (int32_t q = 0; q < 1024; q++)
                inside += in_butt(v[0], v[1], p % W * 256 + q % 32 * 8 + 4,
                                  p / W * 256 + q / 32 * 8 + 4, width / 2, square ? width / 2 : 0);
            inside = 4 * inside - covers[p / W][p % W];
            wrong += inside > 384 || inside < -384;
        }
        CHECK_EQ(wrong, 0);
    }
}

/* A square of 8 px, 2 wide: with miters 10 x 10 without 6 x 6; bevels take half a square pixel from
 * each corner, and so does a miter limit below the square root of 2. */
static void joints_of_a_square(void)
{
    static const struct etch_point_q8 v[4] = {
        {1024, 1024}, {3072, 1024}, {3072, 3072}, {1024, 3072}};
    static const struct etch_stroke s[3] = {{512, etch_cap_butt, etch_join_miter, 1024},
                                            {512, etch_cap_butt, etch_join_bevel, 1024},
                                            {512, etch_cap_butt, etch_join_miter, 361}};

    for (int32_t i = 0; i < 3; i++) {
        for (int32_t reversed = 0; reversed < 2; reversed++) {
            const struct etch_point_q8 back[4] = {v[3], v[2], v[1], v[0]};
            int32_t wrong = 0;

            start();
            etch_stroke_outline(&to_smooth, reversed != 0 ? back : v, 4, true, &s[i]);
            fill();
            for (int32_t p = 0; p < W * H; p++) {
                const int32_t x = p % W, y = p / W;
                const bool outer = x >= 3 && x < 13 && y >= 3 && y < 13;
                const bool inner = x >= 5 && x < 11 && y >= 5 && y < 11;
                const bool corner = (x == 3 || x == 12) && (y == 3 || y == 12);
                const int32_t expected = !outer || inner ? 0 : corner && i > 0 ? 2048 : 4096;

                wrong += covers[y][x] != expected && !(corner && i > 0);
                wrong += covers[y][x] < expected - 16 || covers[y][x] > expected + 16;
            }
            CHECK_EQ(wrong, 0);
        }
    }
}

/* 4 on, 2 off, begun at 1: on columns of a level line and on past its corner. */
static void dashes_go_round_corners(void)
{
    static const struct etch_point_q8 v[3] = {{512, 768}, {512 + 2560, 768}, {512 + 2560, 4352}};
    static const struct etch_stroke s = {512, etch_cap_butt, etch_join_miter, 1024};
    static const int32_t dash[2] = {1024, 512};
    int32_t wrong = 0;

    start();
    etch_stroke_dashes(&to_smooth, v, 3, &s, dash, 2, 256);
    fill();
    for (int32_t x = 2; x < 11; x++) { /* x - 2 + 1 into the pattern of 6 */
        wrong += covers[2][x] != ((x - 1) % 6 < 4 ? 4096 : 0);
        wrong += covers[3][x] != covers[2][x];
    }
    for (int32_t y = 4; y < 17; y++) /* the corner is 10 px on */
        wrong += covers[y][11] != ((y - 3 + 11) % 6 < 4 ? 4096 : 0);
    CHECK_EQ(wrong, 0);
    CHECK_EQ(covers[17][11], 0);
}

static void what_is_not_a_line_draws_nothing(void)
{
    static const struct etch_point_q8 v[3] = {{512, 512}, {512, 512}, {512, 512}};
    static const struct etch_point_q8 far[3] = {{-4194304, -4194304}, {4194304, 4194304}, {0, 0}};
    static const struct etch_stroke round = {512, etch_cap_round, etch_join_round, 1024};
    static const struct etch_stroke none = {1, etch_cap_round, etch_join_round, 1024};
    static const struct etch_stroke wide = {32768, etch_cap_square, etch_join_miter, 65535};
    static const int32_t dash[2] = {1024, 0}, fine[2] = {1, 1};

    start();
    etch_stroke_outline(&to_smooth, v, 3, true, &round);
    etch_stroke_outline(&to_smooth, v, 0, false, &round);
    etch_stroke_outline(&to_smooth, far, 3, false, &none);
    etch_stroke_dashes(&to_smooth, far, 3, &round, dash, 2, 0);
    etch_stroke_dashes(&to_smooth, far, 3, &round, fine, 1, 0);
    CHECK_EQ(smooth.count, 0);
    etch_stroke_outline(&to_smooth, far, 3, true, &wide);
    fill();
    CHECK_EQ(covers[10][10], 4096);
    start();
    etch_stroke_dashes(&to_smooth, far, 2, &round, fine, 2, 0); /* far too many for the room */
    CHECK_EQ(smooth.status, ETCH_ENOMEM);
}

void suite_stroke(void)
{
    RUN(round_strokes_are_distances);
    RUN(butt_and_square_ends);
    RUN(joints_of_a_square);
    RUN(dashes_go_round_corners);
    RUN(what_is_not_a_line_draws_nothing);
}
