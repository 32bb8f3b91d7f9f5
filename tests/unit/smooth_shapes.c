/* tests/unit: smooth shapes without edges against samples by their equations, neighbours, strips,
 * the ends of the ranges. */
#include "core/base/trig.h"
#include "core/fragment/cover.h"
#include "core/raster/outline.h"
#include "core/raster/smooth_shapes.h"
#include "tests/harness/canvas.h"

void suite_smooth_shapes(void);

enum {
    W = 24,
    H = 20
};

enum kind {
    RING,
    ARC,
    ROUND_RECT,
    FRAME,
    LINE,
    ROUND_LINE,
    KINDS
};

struct shape {
    enum kind kind;
    struct etch_point_q8 a, b;
    int32_t r, width; /* outer, inner; radius, width; -, width */
    uint16_t from;
    uint32_t sweep;
};

static int16_t row_memory[64 + 1];
static uint16_t pixels[W * H];
static struct test_canvas canvas, other;
static int32_t worst_error;

static void draw(const struct etch_surface *to, const struct shape *s,
                 const struct etch_cover_paint *paint)
{
    int16_t *const m = row_memory;

    switch (s->kind) {
    case RING: etch_smooth_ring(to, s->a, s->r, s->width, paint, m); break;
    case ARC: etch_smooth_arc(to, s->a, s->r, s->width, s->from, s->sweep, paint, m); break;
    case ROUND_RECT: etch_smooth_round_rect(to, s->a, s->b, s->r, paint, m); break;
    case FRAME: etch_smooth_round_frame(to, s->a, s->b, s->r, s->width, paint, m); break;
    case LINE: etch_smooth_line(to, s->a, s->b, s->width, paint, m); break;
    default: etch_smooth_line_round(to, s->a, s->b, s->width, paint, m); break;
    }
}

/* ---- the equations, for points in 1/1024 px
 * ------------------------------------------------------ */

static bool in_disc(int64_t x, int64_t y, int64_t r)
{
    return r > 0 && x * x + y * y <= r * r;
}

static bool after(uint16_t angle, int64_t x, int64_t y)
{
    const int64_t ux = etch_cos_q30(angle), uy = etch_sin_q30(angle);
    const int64_t cross = ux * y - uy * x;

    return cross > 0 || (cross == 0 && ux * x + uy * y >= 0);
}

static bool in_sector(uint16_t from, uint32_t sweep, int64_t x, int64_t y)
{
    const uint16_t to = (uint16_t)(from + (sweep & 65535));

    return sweep >= 65536 || (sweep <= 32768 ? sweep != 0 && after(from, x, y) && !after(to, x, y)
                                             : after(from, x, y) || !after(to, x, y));
}

static bool in_round_rect(const struct shape *s, int64_t inset, int64_t x, int64_t y)
{
    const int64_t x0 = 4 * (int64_t)(s->a.x < s->b.x ? s->a.x : s->b.x) + inset;
    const int64_t y0 = 4 * (int64_t)(s->a.y < s->b.y ? s->a.y : s->b.y) + inset;
    const int64_t x1 = 4 * (int64_t)(s->a.x < s->b.x ? s->b.x : s->a.x) - inset;
    const int64_t y1 = 4 * (int64_t)(s->a.y < s->b.y ? s->b.y : s->a.y) - inset;
    const int64_t w = x1 - x0 + 2 * inset, h = y1 - y0 + 2 * inset, most = (w < h ? w : h) / 2;
    const int64_t full = 4 * (int64_t)s->r < most ? 4 * (int64_t)s->r : most;
    const int64_t r = full - inset > 0 ? full - inset : 0;
    const int64_t dx = x < x0 + r ? x0 + r - x : x > x1 - r ? x - (x1 - r) : 0;
    const int64_t dy = y < y0 + r ? y0 + r - y : y > y1 - r ? y - (y1 - r) : 0;

    return x >= x0 && x < x1 && y >= y0 && y < y1 && dx * dx + dy * dy <= r * r;
}

static bool in_line(const struct shape *s, int64_t x, int64_t y)
{
    const int64_t ax = 4 * (int64_t)s->a.x, ay = 4 * (int64_t)s->a.y;
    const int64_t dx = 4 * (int64_t)s->b.x - ax, dy = 4 * (int64_t)s->b.y - ay;
    const int64_t along = dx * (x - ax) + dy * (y - ay), length = dx * dx + dy * dy;
    const int64_t cross = dx * (y - ay) - dy * (x - ax), half = 2 * (int64_t)s->width;

    return length > 0 && along >= 0 && along <= length && cross * cross <= half * half * length;
}

static bool is_inside(const struct shape *s, int64_t x, int64_t y)
{
    const int64_t dx = x - 4 * (int64_t)s->a.x, dy = y - 4 * (int64_t)s->a.y;

    switch (s->kind) {
    case RING:
    case ARC:
        return in_disc(dx, dy, 4 * (int64_t)s->r) && !in_disc(dx, dy, 4 * (int64_t)s->width) &&
               (s->kind == RING || in_sector(s->from, s->sweep, dx, dy));
    case ROUND_RECT: return in_round_rect(s, 0, x, y);
    case FRAME: return in_round_rect(s, 0, x, y) && !in_round_rect(s, 4 * (int64_t)s->width, x, y);
    default:
        return in_line(s, x, y) ||
               (s->kind == ROUND_LINE &&
                (in_disc(dx, dy, 2 * (int64_t)s->width) ||
                 in_disc(x - 4 * (int64_t)s->b.x, y - 4 * (int64_t)s->b.y, 2 * (int64_t)s->width)));
    }
}

/* Of n x n samples in the pixel, in 4096ths. */
static int32_t sampled(const struct shape *s, int32_t px, int32_t py, int32_t n)
{
    const int32_t step = 1024 / n;
    int32_t inside = 0;

    for (int32_t i = 0; i < n; i++)
        for (int32_t k = 0; k < n; k++)
            inside += is_inside(s, px * 1024 + step * k + step / 2,
                                py * 1024 + step * i + step / 2);
    return (int32_t)(INT64_C(4096) * inside / (n * n));
}

/* ---- covers -------------------------------------------------------------------------------------
 */

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
        k->broken += cover[i] <= 0 || cover[i] > ETCH_COVER_ONE;
        k->cover[y][x + i] += cover[i];
    }
}

static int32_t covers[H][W], again[H][W];

/* Adds the covers of a shape to what is there. */
static void add(int32_t to[H][W], const struct shape *s)
{
    struct etch_surface surface;
    struct keep k = {{keep}, to, 0};

    CHECK_EQ(etch_surface_init(&surface, pixels, (struct etch_rect){0, 0, W, H}, W), ETCH_OK);
    draw(&surface, s, &k.paint);
    CHECK_EQ(k.broken, 0);
}

static void wipe(int32_t cover[H][W])
{
    for (int32_t i = 0; i < W * H; i++)
        cover[i / W][i % W] = 0;
}

static struct etch_point_q8 place(uint32_t *seed)
{
    const struct etch_point_q8 p = {test_range(seed, -512, 256 * W + 512),
                                    test_range(seed, -512, 256 * H + 512)};

    return p;
}

static struct shape random_shape(uint32_t *seed, int32_t i)
{
    struct shape s = {(enum kind)(i % KINDS), place(seed), place(seed), 0, 0, 0, 0};

    s.r = test_range(seed, 0, i % 4 == 0 ? 60000 : i % 4 == 1 ? 500 : 2500);
    s.width = s.kind <= ARC     ? test_range(seed, -300, s.r)
              : s.kind == FRAME ? test_range(seed, 60, 700)
                                : 2 * test_range(seed, 20, 1200);
    s.from = (uint16_t)(i % 3 == 0 ? test_range(seed, 0, 7) * 8192
                                   : (int32_t)(test_random(seed) & 65535));
    s.sweep = (uint32_t)(i % 5 == 0 ? test_range(seed, 0, 8) * 8192 : test_range(seed, 0, 65536));
    if (i % 13 == 0) /* more than a turn: all of it */
        s.sweep = test_random(seed) | 65536;
    if (i % 4 == 0 && s.kind <= ARC) /* an edge of a large one passes */
        s.a.x += test_range(seed, 0, 1) != 0 ? s.r : -s.r;
    return s;
}

/* Of more than two level edges that share a pixel each may add its 1/32. */
static int32_t allowed(const struct shape *s)
{
    const int32_t high = s->a.y < s->b.y ? s->b.y - s->a.y : s->a.y - s->b.y;
    const bool small = s->kind <= ARC ? s->r < 512
                                      : s->kind == FRAME && (high < 1024 || s->width < 256);

    return (small ? 512 : 256) + 16;
}

/* Each pixel within 1/16 of its area, by 64 x 64 samples where a border may be, and by 256 x 256,
 * which err by 1/256 themselves, where these are not sure. */
static void covers_are_areas(void)
{
    uint32_t seed = 1;

    for (int32_t i = 0; i < TEST_COUNT(180) && !test_failed(); i++) {
        const struct shape s = random_shape(&seed, i);
        int32_t worst = 0;

        wipe(covers);
        add(covers, &s);
        for (int32_t p = 0; p < W * H; p++) {
            const int32_t cover = covers[p / W][p % W];
            int32_t error = cover - sampled(&s, p % W, p / W, 8);

            if (error != 0 || (cover != 0 && cover != 4096))
                error = cover - sampled(&s, p % W, p / W, 64);
            if (error > 192 || error < -192)
                error = cover - sampled(&s, p % W, p / W, 256);
            error = error < 0 ? -error : error;
            worst = error > worst ? error : worst;
        }
        worst_error = worst > worst_error ? worst : worst_error;
        if (!CHECK(worst <= allowed(&s))) {
            test_note("worst", worst);
            test_note("shape", i), test_note("kind", s.kind);
            test_note("ax", s.a.x), test_note("ay", s.a.y), test_note("bx", s.b.x),
                test_note("by", s.b.y);
            test_note("r", s.r), test_note("width", s.width);
            test_note("from", s.from), test_note("sweep", s.sweep);
        }
    }
}

/* Parts between the same rays, a ring and its hole, a frame and what it frames: 4096 in all, or as
 * much as the whole. */
static void neighbours_add_up(void)
{
    uint32_t seed = 2;

    for (int32_t i = 0; i < TEST_COUNT(400) && !test_failed(); i++) {
        struct shape s = random_shape(&seed, i % 4 == 0 ? FRAME : ARC), part;
        int32_t wrong = 0;

        if (s.kind == ARC && s.width < 1)
            s.width = 1;
        wipe(covers);
        wipe(again);
        part = s;
        if (s.kind == ARC) {
            const int32_t parts = test_range(&seed, 1, 5);
            uint32_t at = 0;

            for (int32_t k = 1; k <= parts; k++) {
                const uint32_t to = k == parts ? 65536
                                               : (uint32_t)test_range(&seed, (int32_t)at, 65535);

                part.from = (uint16_t)(s.from + at);
                part.sweep = to - at;
                add(covers, &part);
                at = to;
            }
            part = s;
            part.kind = RING;
            part.r = s.width, part.width = 0;
            if (s.width < s.r)
                add(covers, &part);
            part.r = s.r;
            if (s.width < s.r)
                add(again, &part);
        } else {
            struct shape inner = s;

            add(covers, &s);
            part.kind = ROUND_RECT;
            add(again, &part);
            inner.kind = ROUND_RECT;
            const int32_t w = s.a.x < s.b.x ? s.b.x - s.a.x : s.a.x - s.b.x;
            const int32_t h = s.a.y < s.b.y ? s.b.y - s.a.y : s.a.y - s.b.y;
            const int32_t most = (w < h ? w : h) / 2, r = s.r < most ? s.r : most;
            const int32_t in = s.width;

            inner.r = r > in ? r - in : 0;
            inner.a.x = (s.a.x < s.b.x ? s.a.x : s.b.x) + in;
            inner.b.x = (s.a.x < s.b.x ? s.b.x : s.a.x) - in;
            inner.a.y = (s.a.y < s.b.y ? s.a.y : s.b.y) + in;
            inner.b.y = (s.a.y < s.b.y ? s.b.y : s.a.y) - in;
            if (inner.a.x < inner.b.x && inner.a.y < inner.b.y)
                add(covers, &inner);
        }
        for (int32_t p = 0; p < W * H; p++)
            wrong += covers[p / W][p % W] != again[p / W][p % W];
        if (!CHECK_EQ(wrong, 0))
            test_note("shape", i), test_note("r", s.r), test_note("width", s.width);
    }
}

static void strips_are_the_whole(void)
{
    const struct etch_rect w = {0, 0, 64, 48};
    const struct etch_cover_flat_paint paint = {{etch_cover_flat}, 0xFD20, 200};
    uint32_t seed = 3;

    for (int32_t i = 0; i < TEST_COUNT(300) && !test_failed(); i++) {
        const int32_t rows = test_range(&seed, 1, 17), column = test_range(&seed, 1, 63);
        const struct shape s = random_shape(&seed, i);

        test_canvas_open(&canvas, w);
        test_canvas_open(&other, w);
        draw(&canvas.surface, &s, &paint.paint);
        for (int32_t y = 0; y < 48; y += rows) {
            const struct etch_rect left = {0, (int16_t)y, (int16_t)column, (int16_t)(y + rows)};
            const struct etch_rect right = {(int16_t)column, (int16_t)y, 64, (int16_t)(y + rows)};

            other.surface.clip = etch_rect_intersect(left, w);
            draw(&other.surface, &s, &paint.paint);
            other.surface.clip = etch_rect_intersect(right, w);
            draw(&other.surface, &s, &paint.paint);
        }
        other.surface.clip = w;
        CHECK_EQ(test_canvas_hash(&canvas), test_canvas_hash(&other));
        CHECK_ONCE(&canvas);
    }
}

/* The ends of the ranges: nothing outside, and what covers all covers all. */
static void shapes_at_the_ends(void)
{
    static const int32_t ends[] = {-(1 << 23), -1, 0, 5000, 1 << 23};
    static const int32_t sizes[] = {INT32_MIN, -1, 0, 1, 300, 1 << 23};
    const struct etch_cover_flat_paint paint = {{etch_cover_flat}, TEST_INK, 255};
    uint32_t seed = 4;

    test_canvas_open(&canvas, (struct etch_rect){0, 0, 40, 30});
    for (int32_t i = 0; i < TEST_COUNT(4000); i++) {
        struct shape s = {(enum kind)(i % KINDS),
                          {ends[test_range(&seed, 0, 4)], ends[test_range(&seed, 0, 4)]},
                          {ends[test_range(&seed, 0, 4)], ends[test_range(&seed, 0, 4)]},
                          sizes[test_range(&seed, 0, 5)],
                          sizes[test_range(&seed, 0, 5)],
                          (uint16_t)(test_range(&seed, 0, 8) * 8192),
                          (uint32_t)test_range(&seed, 0, 8) * 8192};

        if (s.kind >= LINE) {
            s.a.x /= 2, s.a.y /= 2, s.b.x /= 2, s.b.y /= 2;
            s.width = s.width > 32768 ? 32768 : s.width;
        }
        draw(&canvas.surface, &s, &paint.paint);
        CHECK_INSIDE(&canvas);
    }
    test_canvas_wipe(&canvas);
    etch_smooth_disc(&canvas.surface, (struct etch_point_q8){-(1 << 22), 0}, 1 << 23, &paint.paint,
                     row_memory);
    for (int32_t p = 0; p < 40 * 30; p++)
        CHECK_EQ(test_canvas_at(&canvas, p % 40, p / 40), TEST_INK);
}

static void named_shapes_are_rings(void)
{
    const struct etch_cover_flat_paint paint = {{etch_cover_flat}, TEST_INK, 255};
    const struct etch_point_q8 c = etch_pixel_q8(30, 20);
    const struct etch_rect w = {0, 0, 64, 48};

    CHECK_EQ(c.x, 30 * 256 + 128);
    CHECK_EQ(etch_pixel_q8(INT16_MIN, INT16_MAX).y, INT32_C(32767) * 256 + 128);
    for (int32_t i = 0; i < 2; i++) {
        test_canvas_open(&canvas, w);
        test_canvas_open(&other, w);
        if (i == 0)
            etch_smooth_disc(&canvas.surface, c, 3000, &paint.paint, row_memory);
        else
            etch_smooth_circle(&canvas.surface, c, 3000, 301, &paint.paint, row_memory);
        etch_smooth_ring(&other.surface, c, i == 0 ? 3000 : 3151, i == 0 ? -5 : 2850, &paint.paint,
                         row_memory);
        CHECK_EQ(test_canvas_hash(&canvas), test_canvas_hash(&other));
        CHECK(test_canvas_drawn(&canvas, 30, 9));
    }
}

/* A polygon and an outline in strips of which each has room for its own edges alone. */
static void windows_leave_edges_out(void)
{
    static struct etch_smooth_edge edge[300];
    const struct etch_cover_flat_paint paint = {{etch_cover_flat}, 0xFD20, 255};
    const struct etch_point_q8 v[5] = {
        {800, 200}, {15000, 3000}, {9000, 11500}, {2000, 9000}, {5000, 4000}};
    const struct etch_rect w = {0, 0, 64, 48};
    struct etch_smooth smooth;
    const struct etch_outline o = {etch_outline_smooth, &smooth};

    test_canvas_open(&canvas, w);
    test_canvas_open(&other, w);
    etch_smooth_init(&smooth, edge, 300);
    etch_outline_ellipse(&o, etch_pixel_q8(32, 24), 6000, 5000, false);
    CHECK_EQ(smooth.count, 126); /* of 128 two are level */
    etch_smooth_fill_nonzero(&canvas.surface, &smooth, &paint.paint, row_memory);
    CHECK_EQ(etch_smooth_polygon(&canvas.surface, v, 5, edge, 5, &paint.paint, row_memory),
             ETCH_OK);
    CHECK_EQ(etch_smooth_polygon(&canvas.surface, v, 5, edge, 4, &paint.paint, row_memory),
             ETCH_ENOMEM);
    for (int16_t y = 0; y < 48; y = (int16_t)(y + 8)) {
        const struct etch_rect strip = {0, y, 64, (int16_t)(y + 8)};

        other.surface.clip = strip;
        etch_smooth_init(&smooth, edge, 300);
        etch_smooth_window(&smooth, &other.surface);
        etch_outline_ellipse(&o, etch_pixel_q8(32, 24), 6000, 5000, false);
        CHECK(smooth.count < 60);
        etch_smooth_fill_nonzero(&other.surface, &smooth, &paint.paint, row_memory);
        CHECK_EQ(etch_smooth_polygon(&other.surface, v, 5, edge, 5, &paint.paint, row_memory),
                 ETCH_OK);
    }
    other.surface.clip = w;
    CHECK_EQ(test_canvas_hash(&canvas), test_canvas_hash(&other));
}

/* What the header says of seams: a later shape over an earlier one that reaches under it shows the
 * two colours and nothing of what was below both. */
static void overlapped_edges_show_two_colours(void)
{
    const struct etch_cover_flat_paint red = {{etch_cover_flat}, 0xF800, 255};
    const struct etch_cover_flat_paint dark = {{etch_cover_flat}, 0x8000, 255};
    const struct etch_point_q8 c = etch_pixel_q8(24, 22);
    const struct etch_rect w = {0, 0, 48, 44};
    int32_t mixed = 0;

    test_canvas_open(&canvas, w);
    for (int32_t p = 0; p < 48 * 44; p++)
        canvas.surface.pixels[etch_surface_index(&canvas.surface, (int16_t)(p % 48),
                                                 (int16_t)(p / 48))] = 0xFFFF;
    etch_smooth_arc(&canvas.surface, c, 5000, 0, 1000, 20000, &red.paint, row_memory);
    etch_smooth_arc(&canvas.surface, c, 5000, 0, 17000, 20000, &dark.paint, row_memory);
    for (int32_t y = 26; y < 36; y++) /* along the ray of 17000, a little left of downwards */
        for (int32_t x = 20; x < 28; x++) {
            const uint16_t pixel = test_canvas_at(&canvas, x, y);

            CHECK((pixel & 0x07FF) == 0 && pixel >= 0x8000);
            mixed += pixel != 0xF800 && pixel != 0x8000;
        }
    CHECK(mixed >= 8);
}

void suite_smooth_shapes(void)
{
    worst_error = 0;
    RUN(covers_are_areas);
    RUN(neighbours_add_up);
    RUN(strips_are_the_whole);
    RUN(shapes_at_the_ends);
    RUN(named_shapes_are_rings);
    RUN(windows_leave_edges_out);
    RUN(overlapped_edges_show_two_colours);
    test_print_count("largest difference from sampled areas: ", worst_error, " of 4096");
}
