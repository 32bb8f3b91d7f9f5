/* tests/unit: the bounds that interpolation promises, against exact rationals on the snapped
 * vertices, at every pixel of triangles of every kind. */
#include "core/draw/triangle.h"
#include "core/fragment/gouraud.h"
#include "core/raster/plane.h"
#include "tests/harness/canvas.h"
#include "tests/harness/shapes.h"
#include "tests/oracle/triangle.h"

void suite_interpolation(void);

static struct test_canvas canvas;
static int32_t triangles, pixels;

/* At the origin, on a usual screen, where x + y passes 2046, and in the far corner. */
static const struct etch_rect windows[] = {
    {0, 0, 40, 30}, {280, 200, 320, 230}, {1010, 1010, 1050, 1040}, {32727, 32737, 32767, 32767}};

/* A drawn triangle, its exact twin and the attributes of its vertices. */
struct sample {
    struct test_triangle shape;
    struct oracle_triangle exact;
    struct etch_vertex vertex[3];
};

/* Channels: anything, full steps, a ramp of one step, constant. */
static void random_color(struct etch_vertex v[3], uint32_t *seed)
{
    const int kind = test_range(seed, 0, 4);
    int i;

    for (i = 0; i < 3; i++) {
        const uint32_t bits = test_random(seed);

        v[i].r = (uint8_t)(kind == 1 ? 255 * (bits & 1) : kind == 2 ? 99 + (bits & 1) : bits >> 24);
        v[i].g = (uint8_t)(kind == 1 ? 255 * (bits >> 1 & 1) : bits >> 16 & 255);
        v[i].b = (uint8_t)(kind == 2 ? bits >> 9 & 3 : bits >> 8 & 255);
        v[i].a = 255;
        if (kind == 3 && i > 0) {
            v[i].r = v[0].r;
            v[i].b = v[0].b;
        }
    }
}

/* Depths 0 .. 65535.0: anything, the ends, a ramp of one unit. */
static void random_depth(struct etch_vertex v[3], uint32_t *seed)
{
    const int kind = test_range(seed, 0, 3);
    int i;

    for (i = 0; i < 3; i++) {
        const uint32_t bits = test_random(seed);

        if (kind == 1)
            v[i].z_q16 = (bits & 1) != 0 ? UINT32_C(0xFFFF0000) : 0;
        else if (kind == 2)
            v[i].z_q16 = UINT32_C(0x7FFF0000) + (bits & UINT32_C(0x1FFFF));
        else
            v[i].z_q16 = bits > UINT32_C(0xFFFF0000) ? UINT32_C(0xFFFF0000) : bits;
    }
}

static void random_sample(struct sample *s, int32_t i, uint32_t *seed)
{
    int k;

    test_triangle_make(&s->shape, (enum test_triangle_kind)(i % TEST_TRIANGLE_KINDS),
                       windows[i / TEST_TRIANGLE_KINDS % 4], seed);
    oracle_triangle_make(&s->exact, s->shape.x, s->shape.y);
    for (k = 0; k < 3; k++) {
        s->vertex[k].x_q8 = s->shape.x[k];
        s->vertex[k].y_q8 = s->shape.y[k];
    }
    random_color(s->vertex, seed);
    random_depth(s->vertex, seed);
    test_canvas_open(&canvas, windows[i / TEST_TRIANGLE_KINDS % 4]);
}

static void note_sample(const struct sample *s, int32_t x, int32_t y)
{
    int i;

    test_note("pixel x", x);
    test_note("pixel y", y);
    for (i = 0; i < 3; i++) {
        test_note("x_q8", s->vertex[i].x_q8);
        test_note("y_q8", s->vertex[i].y_q8);
        test_note("z_q16", s->vertex[i].z_q16);
        test_note("rgb", (int32_t)s->vertex[i].r << 16 | s->vertex[i].g << 8 | s->vertex[i].b);
    }
}

/* |got - value / unit| <= bound / 2^17, all times area * unit * 2^17: at most 2^17 * 2^16 * 2^48
 * * 2^16 = 2^97. `value` is the exact one times the area. */
static bool within(uint32_t got, struct wide value, uint64_t area, uint32_t unit, uint32_t bound)
{
    const struct wide mine = wide_scale(wide_product(area, got), unit);
    const struct wide allowed = wide_scale(wide_product(area, unit), bound);

    return wide_at_most(wide_scale(wide_distance(mine, value), UINT32_C(1) << 17), allowed);
}

/* 1/2 + 1/64 of a step in 2^-17. */
#define NEAR_BOUND (UINT32_C(65536) + 2048)

/* One channel: within the bound and between the rounded least and greatest vertex. */
static bool channel_ok(const struct sample *s, int32_t x, int32_t y, uint32_t got, uint32_t full,
                       const uint8_t c[3])
{
    const uint32_t value[3] = {c[0] * full, c[1] * full, c[2] * full};
    uint32_t least = UINT32_MAX, greatest = 0;
    int i;

    for (i = 0; i < 3; i++) {
        const uint32_t rounded = (2 * value[i] + 255) / 510;

        least = rounded < least ? rounded : least;
        greatest = rounded > greatest ? rounded : greatest;
    }
    return got >= least && got <= greatest &&
           within(got, oracle_triangle_value(&s->exact, x, y, value), (uint64_t)s->exact.area, 255,
                  NEAR_BOUND);
}

static bool color_ok(const struct sample *s, int32_t x, int32_t y, uint16_t color)
{
    const struct etch_vertex *v = s->vertex;
    const uint8_t r[3] = {v[0].r, v[1].r, v[2].r}, g[3] = {v[0].g, v[1].g, v[2].g};
    const uint8_t b[3] = {v[0].b, v[1].b, v[2].b};

    return channel_ok(s, x, y, color >> 11, 31, r) && channel_ok(s, x, y, color >> 5 & 63, 63, g) &&
           channel_ok(s, x, y, color & 31, 31, b);
}

static bool depth_ok(const struct sample *s, int32_t x, int32_t y, uint16_t depth)
{
    const struct etch_vertex *v = s->vertex;
    const uint32_t z[3] = {v[0].z_q16, v[1].z_q16, v[2].z_q16};
    const uint32_t sum = (uint32_t)(x + y);

    return within(depth, oracle_triangle_value(&s->exact, x, y, z), (uint64_t)s->exact.area, 65536,
                  sum <= 2046 ? NEAR_BOUND : 65536 + sum + 1);
}

/* Colour and depth of every covered pixel; the others untouched. */
static void check_pixels(const struct sample *s)
{
    const struct etch_rect clip = canvas.surface.clip;
    int32_t x, y;

    for (y = clip.y0; y < clip.y1; y++) {
        for (x = clip.x0; x < clip.x1; x++) {
            const size_t at = etch_surface_index(&canvas.surface, (int16_t)x, (int16_t)y);
            const uint16_t color = canvas.surface.pixels[at], depth = canvas.surface.depth[at];

            if (!oracle_triangle_covers(&s->exact, x, y)) {
                CHECK(color == TEST_BACKGROUND && depth == UINT16_MAX);
                continue;
            }
            pixels++;
            if (!CHECK(color_ok(s, x, y, color)) || !CHECK(depth_ok(s, x, y, depth)))
                note_sample(s, x, y);
        }
    }
    CHECK_ONCE(&canvas);
}

static void draw(const struct sample *s, const uint8_t order[3])
{
    const struct etch_vertex *const v[3] = {&s->vertex[order[0]], &s->vertex[order[1]],
                                            &s->vertex[order[2]]};

    etch_triangle_gouraud_depth(&canvas.surface, v, etch_kernel_gouraud_lequal);
}

static void color_and_depth_keep_their_bounds(void)
{
    uint32_t seed = 41;
    int32_t i;

    for (i = 0; i < TEST_COUNT(20000) && !test_failed(); i++) {
        struct sample s;
        uint32_t hash;
        int k;

        random_sample(&s, i, &seed);
        draw(&s, test_orders[0]);
        check_pixels(&s);
        triangles++;
        hash = test_canvas_hash(&canvas);
        for (k = 1; k < 6; k++) { /* the order of the vertices changes no value */
            test_canvas_wipe(&canvas);
            draw(&s, test_orders[k]);
            if (!CHECK_EQ(test_canvas_hash(&canvas), hash))
                note_sample(&s, 0, 0);
        }
    }
}

/* The colour kernel without depth gives the same colours. */
static void color_without_depth_is_the_same(void)
{
    uint32_t seed = 42;
    int32_t i, x, y;

    for (i = 0; i < TEST_COUNT(2000) && !test_failed(); i++) {
        static uint16_t first[64 * 48];
        struct sample s;
        const struct etch_vertex *const v[3] = {&s.vertex[0], &s.vertex[1], &s.vertex[2]};
        const struct etch_rect *clip = &canvas.surface.clip;
        int32_t wrong = 0, n = 0;

        random_sample(&s, i, &seed);
        draw(&s, test_orders[0]);
        for (y = clip->y0; y < clip->y1; y++)
            for (x = clip->x0; x < clip->x1; x++)
                first[n++] = test_canvas_at(&canvas, x, y);
        test_canvas_wipe(&canvas);
        etch_triangle_gouraud(&canvas.surface, v, etch_kernel_gouraud);
        n = 0;
        for (y = clip->y0; y < clip->y1; y++)
            for (x = clip->x0; x < clip->x1; x++)
                wrong += first[n++] != test_canvas_at(&canvas, x, y) ||
                         canvas.surface.depth[etch_surface_index(
                             &canvas.surface, (int16_t)x, (int16_t)y)] != UINT16_MAX;
        if (!CHECK_EQ(wrong, 0))
            note_sample(&s, 0, 0);
    }
}

/* Equal values at the vertices give exactly the rounded value at every pixel. */
static void constants_stay_constant(void)
{
    uint32_t seed = 43;
    int32_t i, x, y;

    for (i = 0; i < TEST_COUNT(5000) && !test_failed(); i++) {
        const struct etch_rect *clip = &canvas.surface.clip;
        struct sample s;
        uint16_t color, depth;
        int32_t wrong = 0;
        int k;

        random_sample(&s, i, &seed);
        for (k = 1; k < 3; k++) {
            s.vertex[k].r = s.vertex[0].r;
            s.vertex[k].g = s.vertex[0].g;
            s.vertex[k].b = s.vertex[0].b;
            s.vertex[k].z_q16 = s.vertex[0].z_q16;
        }
        color = (uint16_t)((2 * 31 * s.vertex[0].r + 255) / 510 << 11 |
                           (2 * 63 * s.vertex[0].g + 255) / 510 << 5 |
                           (2 * 31 * s.vertex[0].b + 255) / 510);
        depth = (uint16_t)((s.vertex[0].z_q16 + 32768) >> 16);
        draw(&s, test_orders[i % 6]);
        for (y = clip->y0; y < clip->y1; y++) {
            for (x = clip->x0; x < clip->x1; x++) {
                const size_t at = etch_surface_index(&canvas.surface, (int16_t)x, (int16_t)y);

                wrong += oracle_triangle_covers(&s.exact, x, y) &&
                         (canvas.surface.pixels[at] != color || canvas.surface.depth[at] != depth);
            }
        }
        if (!CHECK_EQ(wrong, 0))
            note_sample(&s, 0, 0);
    }
}

/* ---- the plane equation itself, and barycentric weights ----------------------------------------- */

static struct etch_triangle setup_of(const struct sample *s)
{
    const struct etch_point_q8 v[3] = {{s->shape.x[0], s->shape.y[0]},
                                       {s->shape.x[1], s->shape.y[1]},
                                       {s->shape.x[2], s->shape.y[2]}};
    struct etch_triangle t;

    CHECK(etch_triangle_setup(&t, v));
    return t;
}

/* |got - exact| <= (x + y + 1) / 2 units, where a value just below 0 has wrapped round. */
static bool plane_ok(const struct sample *s, int32_t x, int32_t y, uint32_t got,
                     const uint32_t value[3])
{
    const uint64_t area = (uint64_t)s->exact.area;
    const struct wide turn = wide_product(area, UINT64_C(1) << 32);
    struct wide distance = wide_distance(wide_product(area, got),
                                         oracle_triangle_value(&s->exact, x, y, value));

    if (wide_at_most(wide_distance(turn, distance), distance))
        distance = wide_distance(turn, distance);
    return wide_at_most(wide_scale(distance, 2), wide_product(area, (uint64_t)(x + y + 1)));
}

static void planes_keep_their_bound(void)
{
    uint32_t seed = 44;
    int32_t i, x, y;

    for (i = 0; i < TEST_COUNT(20000) && !test_failed(); i++) {
        const struct etch_rect *clip = &canvas.surface.clip;
        struct sample s;
        struct etch_triangle t;
        struct etch_plane plane;
        uint32_t value[3];
        int k;

        random_sample(&s, i, &seed);
        for (k = 0; k < 3; k++) {
            value[k] = test_random(&seed);
            if (i % 7 == 0)
                value[k] = (value[k] & 1) != 0 ? UINT32_MAX : 0;
        }
        if (s.exact.area == 0)
            continue;
        t = setup_of(&s);
        etch_plane_setup(&plane, &t, value);
        for (y = clip->y0; y < clip->y1; y++) {
            for (x = clip->x0; x < clip->x1; x++) {
                if (!oracle_triangle_covers(&s.exact, x, y))
                    continue;
                pixels++;
                if (!CHECK(plane_ok(&s, x, y, etch_plane_at(&plane, (int16_t)x, (int16_t)y),
                                    value)))
                    note_sample(&s, x, y);
            }
        }
    }
}

/* What the user's function is told, checked on the spot. */
struct weights_check {
    const struct sample *sample;
    uint8_t order[3]; /* as sorted: the bound is for the first two */
};

static bool weight_ok(const struct sample *s, int32_t x, int32_t y, uint32_t b, uint8_t vertex,
                      uint32_t times)
{
    uint32_t value[3] = {0, 0, 0};

    value[vertex] = 65536;
    return b <= 65536 && within(b, oracle_triangle_value(&s->exact, x, y, value),
                                (uint64_t)s->exact.area, 1,
                                times * (65536 + 2 * (uint32_t)(x + y + 1)));
}

static uint16_t check_weights(void *context, int16_t x, int16_t y, const uint32_t b_q16[3])
{
    const struct weights_check *c = context;
    const uint8_t *o = c->order;

    pixels++;
    CHECK(oracle_triangle_covers(&c->sample->exact, x, y));
    CHECK_EQ((int64_t)b_q16[0] + b_q16[1] + b_q16[2], 65536);
    if (!CHECK(weight_ok(c->sample, x, y, b_q16[o[0]], o[0], 1)) ||
        !CHECK(weight_ok(c->sample, x, y, b_q16[o[1]], o[1], 1)) ||
        !CHECK(weight_ok(c->sample, x, y, b_q16[o[2]], o[2], 2)))
        note_sample(c->sample, x, y);
    return TEST_INK;
}

static void weights_sum_to_one_and_keep_their_bound(void)
{
    uint32_t seed = 45;
    int32_t i, x, y;

    for (i = 0; i < TEST_COUNT(10000) && !test_failed(); i++) {
        const struct etch_rect *clip = &canvas.surface.clip;
        struct sample s;
        const struct etch_vertex *const v[3] = {&s.vertex[0], &s.vertex[1], &s.vertex[2]};
        struct weights_check c = {&s, {0, 1, 2}};
        int32_t wrong = 0;

        random_sample(&s, i, &seed);
        if (s.exact.area != 0) {
            const struct etch_triangle t = setup_of(&s);
            int k;

            for (k = 0; k < 3; k++)
                c.order[k] = t.order[k];
        }
        etch_triangle_barycentric(&canvas.surface, v, check_weights, &c);
        for (y = clip->y0; y < clip->y1; y++)
            for (x = clip->x0; x < clip->x1; x++)
                wrong += oracle_triangle_covers(&s.exact, x, y) !=
                         (test_canvas_at(&canvas, x, y) == TEST_INK);
        CHECK_EQ(wrong, 0);
        CHECK_ONCE(&canvas);
    }
}

void suite_interpolation(void)
{
    triangles = 0;
    pixels = 0;
    RUN(color_and_depth_keep_their_bounds);
    RUN(color_without_depth_is_the_same);
    RUN(constants_stay_constant);
    RUN(planes_keep_their_bound);
    RUN(weights_sum_to_one_and_keep_their_bound);
    test_print_count("", pixels, " pixels against exact rationals, none beyond its bound");
}
