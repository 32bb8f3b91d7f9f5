/* tests/unit: the painter's algorithm and the ordering table against a depth buffer. */
#include "core/base/rgb565.h"
#include "core/draw/mesh.h"
#include "core/draw/ordering.h"
#include "core/draw/painter.h"
#include "core/draw/painter_steps.h"
#include "core/fragment/flat.h"
#include "tests/harness/canvas.h"
#include "tests/harness/sample.h"

void suite_painter(void);

enum {
    MOST = 24,
    ROOM = 3000,
    LIMIT = 1 << 23
};

static struct test_canvas canvas, other;
static struct etch_painter_triangle buffer[ROOM];
static struct etch_ordered ordered[64];
static uint16_t buckets[256];
static struct etch_painter painter;
static int32_t pixels, differing, cuts, scenes;

struct scene {
    struct etch_vertex v[MOST][3];
    int32_t n;
};

static void color(struct etch_vertex v[3], int32_t i)
{
    int k;

    for (k = 0; k < 3; k++) {
        v[k].r = (uint8_t)(255 - 9 * i);
        v[k].g = (uint8_t)(4 * i);
        v[k].b = (uint8_t)(9 * i);
        v[k].a = 255;
    }
}

/* The number of the triangle that has this colour. */
static int32_t owner(const struct scene *s, uint16_t pixel)
{
    int32_t i;

    for (i = 0; i < s->n; i++)
        if (etch_rgb565(s->v[i][0].r, s->v[i][0].g, s->v[i][0].b) == pixel)
            return i;
    return -1;
}

static void emit(const struct scene *s, struct etch_sink *sink)
{
    int32_t i;

    for (i = 0; i < s->n; i++) {
        const struct etch_vertex *const v[3] = {&s->v[i][0], &s->v[i][1], &s->v[i][2]};

        sink->triangle(sink, v);
    }
}

static void draw_by_depth(const struct scene *s)
{
    struct etch_raster_sink raster;

    test_canvas_wipe(&other);
    etch_raster_sink_init(&raster, &other.surface, etch_triangle_flat_depth,
                          etch_kernel_flat_lequal);
    emit(s, &raster.sink);
}

static enum etch_status draw_by_painter(const struct scene *s, uint16_t room)
{
    struct etch_raster_sink raster;
    enum etch_status status;

    test_canvas_wipe(&canvas);
    etch_raster_sink_init(&raster, &canvas.surface, etch_triangle_flat, etch_kernel_flat);
    etch_painter_init(&painter, buffer, room);
    emit(s, &painter.sink);
    status = etch_painter_sort(&painter);
    etch_painter_draw(&painter, &raster.sink);
    cuts += painter.count > s->n;
    scenes++;
    return status;
}

/* ---- what may differ ---------------------------------------------------------------------------
 */

/* Depth in 2^-16 at a pixel's centre, and how much it changes over 1/256 px in x and y together. */
static int64_t depth_at(const struct etch_vertex v[3], int32_t x, int32_t y, int64_t *change)
{
    struct etch_painter_plane p;
    int64_t dx, dy, whole;

    etch_painter_plane_setup(&p, v);
    dx = 256 * x + 128 - p.at.x_q8;
    dy = 256 * y + 128 - p.at.y_q8;
    *change = ((p.nx < 0 ? -p.nx : p.nx) + (p.ny < 0 ? -p.ny : p.ny)) / p.nz + 2;
    whole = p.nx / p.nz * dx + p.ny / p.nz * dy; /* and the remainders, below nz < 2^38 here */
    return (int64_t)p.at.z_q16 - whole - (p.nx % p.nz * dx + p.ny % p.nz * dy) / p.nz;
}

/* Whether the centre is on no more than `far` / 256 px outside the triangle: it is within when
 * every edge is moved out so far. */
static bool is_near(const struct etch_vertex v[3], int32_t x, int32_t y, int64_t far)
{
    const struct etch_vertex c = {256 * x + 128, 256 * y + 128, 0, 0, 0, 0, 0};
    const int64_t sign = etch_painter_turn(&v[0], &v[1], &v[2]) > 0 ? 1 : -1;
    int k;

    for (k = 0; k < 3; k++) {
        const struct etch_vertex *a = &v[k], *b = &v[(k + 1) % 3];
        const int64_t dx = b->x_q8 - a->x_q8, dy = b->y_q8 - a->y_q8;
        const int64_t w = dx < 0 ? -dx : dx, h = dy < 0 ? -dy : dy;
        const int64_t length = w > h ? w : h; /* at most the edge's */

        if (sign * etch_painter_turn(a, b, &c) < -far * length)
            return false;
    }
    return true;
}

/* A pixel may show triangle a where the depth buffer shows b (-1: background) if their depths tie
 * or the picture of a or b ends there, to the measure of painter.h. */
static bool may_differ(const struct scene *s, int32_t a, int32_t b, int32_t x, int32_t y)
{
    int64_t za, zb, ca, cb;

    if (a < 0 || !is_near(s->v[a], x, y, 2))
        return false; /* a hole, or a colour from elsewhere */
    if (b < 0 || !is_near(s->v[a], x, y, -2))
        return true;
    za = depth_at(s->v[a], x, y, &ca);
    zb = depth_at(s->v[b], x, y, &cb);
    return (za < zb ? zb - za : za - zb) <= 2 * (ca + cb) + 65536 + 2048;
}

static void compare(const struct scene *s)
{
    const struct etch_rect c = canvas.surface.clip;
    int32_t x, y;

    for (y = c.y0; y < c.y1; y++) {
        for (x = c.x0; x < c.x1; x++) {
            const uint16_t drawn = test_canvas_at(&canvas, x, y),
                           right = test_canvas_at(&other, x, y);

            pixels++;
            if (drawn == right)
                continue;
            differing++;
            if (!CHECK(may_differ(s, owner(s, drawn), owner(s, right), x, y))) {
                test_note("x", x), test_note("y", y);
                test_note("drawn", owner(s, drawn)), test_note("right", owner(s, right));
                test_note("of", s->n);
            }
        }
    }
}

static void open(void)
{
    const struct etch_rect w = {0, 0, 64, 48};

    test_canvas_open(&canvas, w);
    test_canvas_open(&other, w);
}

static int32_t held(int32_t v)
{
    return v > LIMIT ? LIMIT : v < -LIMIT ? -LIMIT : v;
}

/* ---- random scenes -----------------------------------------------------------------------------
 */

/* Triangles anywhere over the window, most of them piercing others. */
static void piercing_triangles(void)
{
    static struct scene s;
    uint32_t seed = 1;
    int32_t i, t, k;

    open();
    for (i = 0; i < TEST_COUNT(400) && !test_failed(); i++) {
        const int32_t deep = i % 3 == 0 ? 65535 : i % 3 == 1 ? 2000 : 200;

        s.n = test_range(&seed, 2, i % 8 == 0 ? 16 : 5);
        for (t = 0; t < s.n; t++) {
            for (k = 0; k < 3; k++) {
                struct etch_vertex *v = &s.v[t][k];

                v->x_q8 = test_range(&seed, -10 * 256, 74 * 256);
                v->y_q8 = test_range(&seed, -10 * 256, 58 * 256);
                v->z_q16 = (uint32_t)test_range(&seed, 0, deep) << 16;
                v->z_q16 += v->z_q16 < 0xFFFF0000 ? (uint32_t)test_range(&seed, 0, 65535) : 0;
            }
            color(s.v[t], t);
        }
        draw_by_depth(&s);
        CHECK_EQ(draw_by_painter(&s, ROOM), ETCH_OK);
        compare(&s);
    }
}

/* A ring of bars, each over the next and under the one before. */
static void rings(void)
{
    static struct scene s;
    uint32_t seed = 2;
    int32_t i, t;

    open();
    for (i = 0; i < TEST_COUNT(300) && !test_failed(); i++) {
        s.n = 3;
        for (t = 0; t < 3; t++) {
            static const int32_t at[3][2] = {{10, 40}, {54, 40}, {32, 4}};
            const int32_t *from = at[t], *to = at[(t + 1) % 3];
            struct etch_vertex *v = s.v[t];

            v[0].x_q8 = (from[0] * 5 - to[0]) * 64, v[0].y_q8 = (from[1] * 5 - to[1]) * 64;
            v[1].x_q8 = (to[0] * 5 - from[0]) * 64, v[1].y_q8 = (to[1] * 5 - from[1]) * 64;
            v[2].x_q8 = v[1].x_q8 + test_range(&seed, 500, 2500);
            v[2].y_q8 = v[1].y_q8 + test_range(&seed, 500, 2500);
            v[0].z_q16 = (uint32_t)test_range(&seed, 4000, 5000) << 16;
            v[1].z_q16 = v[2].z_q16 = (uint32_t)test_range(&seed, 1000, 2000) << 16;
            color(v, t);
        }
        draw_by_depth(&s);
        CHECK_EQ(draw_by_painter(&s, ROOM), ETCH_OK);
        CHECK(painter.count > 3); /* there is no order */
        compare(&s);
    }
}

/* A grid of squares over a bumpy ground, at grid depths: many shared edges and vertices. */
static void meshes(void)
{
    static struct scene s;
    uint32_t seed = 3;
    int32_t i, k;

    open();
    for (i = 0; i < TEST_COUNT(200) && !test_failed(); i++) {
        struct etch_vertex g[4][4];
        int32_t x, y;

        for (y = 0; y < 4; y++) {
            for (x = 0; x < 4; x++) {
                g[y][x].x_q8 = x * 5000 + test_range(&seed, -1500, 1500);
                g[y][x].y_q8 = y * 4000 + test_range(&seed, -1500, 1500);
                g[y][x].z_q16 = (uint32_t)test_range(&seed, 1, 9) << 28;
            }
        }
        s.n = 0;
        for (y = 0; y < 3; y++) {
            for (x = 0; x < 3; x++) {
                for (k = 0; k < 2; k++) {
                    s.v[s.n][0] = g[y + k][x + k];
                    s.v[s.n][1] = g[y][x + 1];
                    s.v[s.n][2] = g[y + 1][x];
                    color(s.v[s.n], s.n);
                    s.n++;
                }
            }
        }
        draw_by_depth(&s);
        CHECK_EQ(draw_by_painter(&s, ROOM), ETCH_OK);
        compare(&s);
    }
}

/* Whatever the vertices and however little the room: it ends, and says what it could not do. */
static void hostile_triangles_end(void)
{
    static struct scene s;
    uint32_t seed = 4;
    int32_t i, t, k, short_of = 0;

    open();
    for (i = 0; i < TEST_COUNT(600) && !test_failed(); i++) {
        const uint16_t room = (uint16_t)test_range(&seed, 0, 40);
        const int32_t range = i % 2 != 0 ? LIMIT : 16000;
        enum etch_status status;

        s.n = test_range(&seed, 0, MOST);
        for (t = 0; t < s.n; t++) {
            for (k = 0; k < 3; k++) {
                s.v[t][k].x_q8 = held(test_range(&seed, -range, range) * (i % 5 == 0 ? 99 : 1));
                s.v[t][k].y_q8 = test_range(&seed, i % 7 == 0 ? 0 : -range, i % 7 == 0 ? 3 : range);
                s.v[t][k].z_q16 = i % 3 != 0 ? test_random(&seed) : test_random(&seed) >> 31;
            }
            if (test_range(&seed, 0, 9) == 0)
                s.v[t][2] = s.v[t][0];
            color(s.v[t], t);
        }
        buffer[room].next = 4711;
        status = draw_by_painter(&s, room);
        CHECK_EQ(status, painter.lost != 0 || painter.uncut ? ETCH_ENOMEM : ETCH_OK);
        CHECK_EQ(buffer[room].next, 4711);
        CHECK(painter.count <= room);
        short_of += status != ETCH_OK;
        CHECK_INSIDE(&canvas);
        draw_by_depth(&s);
        if (range == 16000 && painter.lost == 0) { /* nothing is missing */
            int32_t x, y, holes = 0;

            for (y = 0; y < 48; y++)
                for (x = 0; x < 64; x++)
                    holes += test_canvas_drawn(&other, x, y) && !test_canvas_drawn(&canvas, x, y);
            CHECK_EQ(holes, 0);
        }
    }
    CHECK(short_of > 0);
}

/* Two triangles that pierce each other, by hand: the cut runs down the middle. */
static void a_piercing_pair(void)
{
    static struct scene s = {{{{0, 0, 100 << 16, 0, 0, 0, 0},
                               {4096, 0, 300 << 16, 0, 0, 0, 0},
                               {0, 4096, 100 << 16, 0, 0, 0, 0}},
                              {{0, 0, 300 << 16, 0, 0, 0, 0},
                               {4096, 0, 100 << 16, 0, 0, 0, 0},
                               {0, 4096, 300 << 16, 0, 0, 0, 0}}},
                             2};
    int32_t x, wrong = 0;

    color(s.v[0], 0), color(s.v[1], 1);
    open();
    CHECK_EQ(draw_by_painter(&s, ROOM), ETCH_OK);
    for (x = 0; x < 15; x++)
        wrong += owner(&s, test_canvas_at(&canvas, x, 0)) != (x < 8 ? 0 : 1);
    CHECK_EQ(wrong, 0);
    CHECK(painter.count > 2);
    CHECK_EQ(draw_by_painter(&s, 2), ETCH_ENOMEM); /* drawn, but not cut */
    CHECK_EQ(painter.count, 2);
    CHECK(test_canvas_drawn(&canvas, 3, 3));
    CHECK_EQ(draw_by_painter(&s, 1), ETCH_ENOMEM);
    CHECK_EQ(painter.lost, 1);
    CHECK_EQ(draw_by_painter(&s, 0), ETCH_ENOMEM);
    CHECK(!test_canvas_drawn(&canvas, 3, 3));
}

/* ---- the ordering table ------------------------------------------------------------------------
 */

static void list_color(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    (void)sink;
    if (CHECK(pixels < 64))
        ordered[pixels++].v[0].r = v[0]->r;
}

/* Flat triangles come out by bucket, far ones first, and within one as they came. */
static void tables_sort_by_depth(void)
{
    static const uint32_t z[] = {0, 0xFFFF, 300, 0x8000, 255, 256, 0x8001, 0};
    static const uint8_t expected[] = {1, 3, 6, 2, 5, 0, 4, 7};
    static struct etch_ordered kept[8];
    struct etch_ordering o;
    struct etch_sink list = {.triangle = list_color};
    struct etch_vertex v = {0};
    const struct etch_vertex *const corner[3] = {&v, &v, &v};
    const int32_t before = pixels;
    uint8_t i;

    etch_ordering_init(&o, kept, 8, buckets, 256);
    for (i = 0; i < 8; i++) {
        v.z_q16 = z[i] << 16;
        v.r = i;
        o.sink.triangle(&o.sink, corner);
    }
    CHECK_EQ(o.count, 8);
    CHECK_EQ(o.lost, 0);
    o.sink.triangle(&o.sink, corner);
    CHECK_EQ(o.lost, 1);
    pixels = 0;
    etch_ordering_draw(&o, &list);
    CHECK_EQ(pixels, 8);
    for (i = 0; i < 8; i++)
        CHECK_EQ(ordered[i].v[0].r, expected[i]);
    v.z_q16 = UINT32_MAX; /* beyond the far end */
    etch_ordering_init(&o, kept, 8, buckets, 1);
    o.sink.triangle(&o.sink, corner);
    etch_ordering_init(&o, kept, 8, buckets, 256);
    o.sink.triangle(&o.sink, corner);
    CHECK_EQ(buckets[255], 0);
    pixels = before;
}

/* Where triangles are parallel to the screen the table is right. */
static void tables_draw_layers(void)
{
    static struct scene s;
    uint32_t seed = 5;
    int32_t i, t, k;

    open();
    for (i = 0; i < TEST_COUNT(200) && !test_failed(); i++) {
        struct etch_raster_sink raster;
        struct etch_ordering o;

        s.n = MOST;
        for (t = 0; t < MOST; t++) {
            const uint32_t z = (uint32_t)test_range(&seed, 0, 255) << 24;

            for (k = 0; k < 3; k++) {
                s.v[t][k].x_q8 = test_range(&seed, -2000, 18000);
                s.v[t][k].y_q8 = test_range(&seed, -2000, 14000);
                s.v[t][k].z_q16 = z;
            }
            color(s.v[t], t);
        }
        draw_by_depth(&s);
        test_canvas_wipe(&canvas);
        etch_raster_sink_init(&raster, &canvas.surface, etch_triangle_flat, etch_kernel_flat);
        etch_ordering_init(&o, ordered, 64, buckets, 256);
        emit(&s, &o.sink);
        etch_ordering_draw(&o, &raster.sink);
        for (k = 0; k < 64 * 48; k++)
            if (!CHECK_EQ(test_canvas_at(&canvas, k % 64, k / 64),
                          test_canvas_at(&other, k % 64, k / 64)))
                break;
    }
}

void suite_painter(void)
{
    RUN(a_piercing_pair);
    RUN(piercing_triangles);
    RUN(rings);
    RUN(meshes);
    RUN(hostile_triangles_end);
    RUN(tables_sort_by_depth);
    RUN(tables_draw_layers);
    test_print_count("", pixels, " pixels against a depth buffer");
    test_print_count("", differing, " differ, all at ties and edges of cuts");
    test_print_count("", cuts, " scenes with cuts");
}
