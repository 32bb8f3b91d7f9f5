/* tests/unit: smooth shapes against 64 x 64 samples a pixel, neighbours, strips and exact blending.
 */
#include "core/base/rgb565.h"
#include "core/fragment/cover.h"
#include "core/raster/outline.h"
#include "tests/harness/canvas.h"

void suite_smooth(void);

enum {
    W = 24,
    H = 20,
    EDGES = 1100
};

static struct etch_smooth_edge edges[EDGES];
static struct etch_smooth smooth;
static int16_t row_memory[64 + 1];
static struct test_canvas canvas, other;

/* A paint that keeps covers. */
struct keep {
    struct etch_cover_paint paint;
    int32_t (*cover)[W];
    int32_t broken;
};

static void keep(const struct etch_surface *s, int16_t x, int16_t y, uint16_t n,
                 const int16_t *cover, const struct etch_cover_paint *paint)
{
    struct keep *k = (struct keep *)(uintptr_t)paint;

    k->broken += x < s->clip.x0 || x + n > s->clip.x1 || y < s->clip.y0 || y >= s->clip.y1;
    for (uint16_t i = 0; i < n && k->broken == 0; i++) {
        k->broken += cover[i] <= 0 || cover[i] > ETCH_COVER_ONE || k->cover[y][x + i] != 0;
        k->cover[y][x + i] = cover[i];
    }
}

static int32_t covers[H][W], again[H][W];

static void wipe(int32_t cover[H][W])
{
    for (int32_t i = 0; i < W * H; i++)
        cover[i / W][i % W] = 0;
}

static struct keep keeper(int32_t cover[H][W])
{
    const struct keep k = {{keep}, cover, 0};

    return k;
}

struct shape {
    struct etch_point_q8 v[12];
    uint16_t n;
};

static void make(struct shape *s, uint32_t *seed)
{
    const int32_t far = test_range(seed, 0, 9) == 0 ? 1 << 23 : 0;

    s->n = (uint16_t)test_range(seed, 3, 7);
    for (uint16_t i = 0; i < s->n; i++) {
        s->v[i].x = far != 0 ? test_range(seed, -far, far) : test_range(seed, -512, 256 * W + 512);
        s->v[i].y = far != 0 ? test_range(seed, -far, far) : test_range(seed, -512, 256 * H + 512);
    }
}

/* How often the contour winds round a point in 1/1024 px (all samples are off its vertices' grid).
 */
static int32_t winding(const struct shape *s, int64_t x, int64_t y)
{
    int32_t n = 0;

    for (uint16_t i = 0; i < s->n; i++) {
        const int64_t ax = s->v[i].x * INT64_C(4), ay = s->v[i].y * INT64_C(4);
        const struct etch_point_q8 next = s->v[i + 1 == s->n ? 0 : i + 1];
        const int64_t bx = next.x * INT64_C(4), by = next.y * INT64_C(4);
        const int64_t side = (bx - ax) * (y - ay) - (by - ay) * (x - ax);

        if (ay < y && by >= y && side > 0)
            n++;
        else if (by < y && ay >= y && side < 0)
            n--;
    }
    return n;
}

/* Samples of 4096 in the pixel that are inside. */
static int32_t sampled(const struct shape *s, int32_t px, int32_t py, bool nonzero)
{
    int32_t n = 0;

    for (int32_t i = 0; i < 64; i++)
        for (int32_t k = 0; k < 64; k++) {
            const int32_t w = winding(s, px * 1024 + 16 * k + 8 + 1, py * 1024 + 16 * i + 8 + 1);

            n += nonzero ? w != 0 : w % 2 != 0;
        }
    return n;
}

/* A pixel where up to two edges pass is within 1/16 of its area (the samples themselves err by 1/64
 * an edge). */
static void covers_are_areas(void)
{
    uint32_t seed = 1;

    for (int32_t i = 0; i < TEST_COUNT(40) && !test_failed(); i++) {
        struct shape s;
        struct etch_surface surface;
        struct keep k = keeper(covers);
        static uint16_t pixels[W * H];
        int64_t total = 0;
        int32_t worst = 0;

        make(&s, &seed);
        s.n = i % 2 != 0 ? 3 : s.n;
        CHECK_EQ(etch_surface_init(&surface, pixels, (struct etch_rect){0, 0, W, H}, W), ETCH_OK);
        wipe(covers);
        etch_smooth_init(&smooth, edges, EDGES);
        CHECK_EQ(etch_smooth_add(&smooth, s.v, s.n), ETCH_OK);
        (i % 4 < 2 ? etch_smooth_fill_nonzero : etch_smooth_fill_evenodd)(&surface, &smooth,
                                                                          &k.paint, row_memory);
        CHECK_EQ(k.broken, 0);
        for (int32_t p = 0; p < W * H; p++) {
            const int32_t error = covers[p / W][p % W] - sampled(&s, p % W, p / W, i % 4 < 2);

            worst = error > worst ? error : -error > worst ? -error : worst;
            total += error < 0 ? -error : error;
        }
        /* one pixel in many has more than two level edges; triangles never do away from their
         * corners */
        CHECK(worst <= (s.n == 3 ? 256 + 64 : 512));
        CHECK(total < W * H * 32);
        if (test_failed())
            test_note("shape", i), test_note("worst", worst);
    }
}

/* Two shapes that share a zigzag cover each pixel of a rectangle by 4096 together. */
static void neighbours_add_up(void)
{
    uint32_t seed = 2;

    for (int32_t i = 0; i < TEST_COUNT(300) && !test_failed(); i++) {
        struct shape s = {{{0, 0}}, 8};
        struct etch_surface surface;
        static uint16_t pixels[W * H];
        struct keep one = keeper(covers), two = keeper(again);
        int32_t wrong = 0;

        CHECK_EQ(etch_surface_init(&surface, pixels, (struct etch_rect){0, 0, W, H}, W), ETCH_OK);
        for (int32_t k = 0; k < 6; k++) {
            s.v[k].x = test_range(&seed, 1, 256 * W - 1);
            s.v[k].y = k == 0 ? 0 : k == 5 ? 256 * H : test_range(&seed, 0, 256 * H);
        }
        s.v[6].y = 256 * H, s.v[7].y = 0;
        wipe(covers);
        wipe(again);
        for (int32_t side = 0; side < 2; side++) {
            s.v[6].x = s.v[7].x = side * 256 * W;
            etch_smooth_init(&smooth, edges, EDGES);
            CHECK_EQ(etch_smooth_add(&smooth, s.v, s.n), ETCH_OK);
            etch_smooth_fill_evenodd(&surface, &smooth, side == 0 ? &one.paint : &two.paint,
                                     row_memory);
        }
        for (int32_t p = 0; p < W * H; p++)
            wrong += covers[p / W][p % W] + again[p / W][p % W] != ETCH_COVER_ONE;
        CHECK_EQ(wrong, 0);
    }
}

/* Round shapes: ring, arc, rounded rectangle and ellipse, each in strips and columns as in one
 * piece. */
static void outline(const struct etch_outline *o, int32_t kind, uint32_t *seed)
{
    const struct etch_point_q8 c = {test_range(seed, 0, 64 * 256), test_range(seed, 0, 48 * 256)};
    const struct etch_point_q8 d = {test_range(seed, 0, 64 * 256), test_range(seed, 0, 48 * 256)};
    const int32_t r = test_range(seed, 0, 9000);

    if (kind == 0)
        etch_outline_ellipse(o, c, r, test_range(seed, 0, 5000), false);
    else if (kind == 1)
        etch_outline_arc(o, c, r, test_range(seed, 0, 6000), (uint16_t)test_range(seed, 0, 65535),
                         (uint32_t)test_range(seed, 0, 70000));
    else
        etch_outline_round_rect(o, c, d, r);
}

static void strips_are_the_whole(void)
{
    const struct etch_rect w = {0, 0, 64, 48};
    const struct etch_outline o = {etch_outline_smooth, &smooth};
    const struct etch_cover_flat_paint paint = {{etch_cover_flat}, 0xFD20, 200};
    uint32_t seed = 3;

    for (int32_t i = 0; i < TEST_COUNT(600) && !test_failed(); i++) {
        const int32_t rows = test_range(&seed, 1, 17), column = test_range(&seed, 1, 63);

        test_canvas_open(&canvas, w);
        test_canvas_open(&other, w);
        etch_smooth_init(&smooth, edges, EDGES);
        outline(&o, i % 3, &seed);
        CHECK_EQ(smooth.status, ETCH_OK);
        etch_smooth_fill_nonzero(&canvas.surface, &smooth, &paint.paint, row_memory);
        for (int32_t y = 0; y < 48; y += rows) {
            const struct etch_rect left = {0, (int16_t)y, (int16_t)column, (int16_t)(y + rows)};
            const struct etch_rect right = {(int16_t)column, (int16_t)y, 64, (int16_t)(y + rows)};

            other.surface.clip = etch_rect_intersect(left, w);
            etch_smooth_fill_nonzero(&other.surface, &smooth, &paint.paint, row_memory);
            other.surface.clip = etch_rect_intersect(right, w);
            etch_smooth_fill_nonzero(&other.surface, &smooth, &paint.paint, row_memory);
        }
        other.surface.clip = w;
        CHECK_EQ(test_canvas_hash(&canvas), test_canvas_hash(&other));
        CHECK_INSIDE(&canvas);
        CHECK_INSIDE(&other);
    }
}

static bool in_disc(int64_t x, int64_t y, int64_t r)
{
    return r > 0 && x * x + y * y <= r * r;
}

/* Rings, a part of which is outside, against samples by their equation. */
static void rings_are_rings(void)
{
    const struct etch_outline o = {etch_outline_smooth, &smooth};
    uint32_t seed = 4;

    for (int32_t i = 0; i < TEST_COUNT(40) && !test_failed(); i++) {
        const struct etch_point_q8 c = {test_range(&seed, 0, 256 * W),
                                        test_range(&seed, 0, 256 * H)};
        const int32_t outer = test_range(&seed, 300, i % 4 == 0 ? 200000 : 3000);
        const int32_t inner = i % 3 == 0 ? 0 : test_range(&seed, 0, outer - 300);
        struct etch_surface surface;
        static uint16_t pixels[W * H];
        struct keep k = keeper(covers);
        int32_t wrong = 0;

        CHECK_EQ(etch_surface_init(&surface, pixels, (struct etch_rect){0, 0, W, H}, W), ETCH_OK);
        wipe(covers);
        etch_smooth_init(&smooth, edges, EDGES);
        etch_outline_arc(&o, c, outer, inner, 0, 65536);
        CHECK_EQ(smooth.status, ETCH_OK);
        etch_smooth_fill_nonzero(&surface, &smooth, &k.paint, row_memory);
        for (int32_t p = 0; p < W * H; p++) {
            int32_t n = 0;

            for (int32_t q = 0; q < 4096; q++) {
                const int64_t x = p % W * 1024 + q % 64 * 16 + 8 - c.x * INT64_C(4);
                const int64_t y = p / W * 1024 + q / 64 * 16 + 8 - c.y * INT64_C(4);

                n += in_disc(x, y, outer * INT64_C(4)) && !in_disc(x, y, inner * INT64_C(4));
            }
            n -= covers[p / W][p % W];
            wrong += n > 256 || n < -256;
        }
        CHECK_EQ(wrong, 0);
    }
}

/* Every cover and opacity, some colours: once rounded. */
static void blends_are_rounded_once(void)
{
    const struct etch_rect w = {0, 0, 64, 48};
    uint32_t seed = 5;

    test_canvas_open(&canvas, w);
    test_canvas_open(&other, w);
    for (int32_t i = 0; i < TEST_COUNT(100000) && !test_failed(); i++) {
        const uint16_t s = (uint16_t)test_random(&seed), d = (uint16_t)test_random(&seed);
        const int16_t cover = (int16_t)(i < 4096 ? i + 1 : test_range(&seed, 1, 4096));
        const uint8_t opacity = (uint8_t)(i < 4096 ? 255 : test_range(&seed, 0, 255));
        const struct etch_cover_flat_paint paint = {{etch_cover_flat}, s, opacity};
        const int64_t one = 4096 * 255, a = (int64_t)cover * opacity;
        uint16_t expected = 0;

        for (int32_t shift = 0, bits = 5; shift < 16; shift += bits, bits = shift == 5 ? 6 : 5) {
            const int64_t most = (1 << bits) - 1, from = d >> shift & most, to = s >> shift & most;

            expected = (uint16_t)(expected | ((2 * (to * a + from * (one - a)) + one) / (2 * one))
                                                 << shift);
        }
        canvas.surface.pixels[5] = d;
        other.surface.pixels[5] = etch_rgb565_swap(d);
        etch_cover_flat(&canvas.surface, 5, 0, 1, &cover, &paint.paint);
        etch_cover_flat_swapped(&other.surface, 5, 0, 1, &cover, &paint.paint);
        CHECK_EQ(canvas.surface.pixels[5], expected);
        CHECK_EQ(other.surface.pixels[5], etch_rgb565_swap(expected));
    }
}

static void refuses_what_it_cannot_hold(void)
{
    const struct etch_point_q8 v[3] = {{0, 0}, {4096, 0}, {0, 4096}};
    const struct etch_point_q8 far[3] = {{0, 0}, {(1 << 23) + 1, 0}, {0, 4096}};
    const struct etch_rect w = {0, 0, 40, 40};
    const struct etch_cover_flat_paint paint = {{etch_cover_flat}, TEST_INK, 255};

    test_canvas_open(&canvas, w);
    etch_smooth_init(&smooth, edges, 1);
    CHECK_EQ(etch_smooth_add(&smooth, v, 3), ETCH_ENOMEM);
    etch_smooth_fill_nonzero(&canvas.surface, &smooth, &paint.paint, row_memory);
    CHECK(!test_canvas_drawn(&canvas, 2, 2));
    etch_smooth_init(&smooth, edges, 8);
    CHECK_EQ(etch_smooth_add(&smooth, far, 3), ETCH_EINVAL);
    CHECK_EQ(etch_smooth_add(&smooth, v, 3), ETCH_EINVAL);
    etch_smooth_init(&smooth, edges, 2); /* the level edge takes none */
    CHECK_EQ(etch_smooth_add(&smooth, v, 3), ETCH_OK);
    etch_smooth_fill_nonzero(&canvas.surface, &smooth, &paint.paint, row_memory);
    CHECK(test_canvas_drawn(&canvas, 2, 2));
    CHECK_INSIDE(&canvas);
}

void suite_smooth(void)
{
    RUN(covers_are_areas);
    RUN(neighbours_add_up);
    RUN(strips_are_the_whole);
    RUN(rings_are_rings);
    RUN(blends_are_rounded_once);
    RUN(refuses_what_it_cannot_hold);
}
