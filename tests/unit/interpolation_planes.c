/* tests/unit: the plane equation itself and the barycentric weights, against exact rationals. */
#include "core/draw/triangle.h"
#include "core/raster/plane.h"
#include "tests/harness/canvas.h"
#include "tests/harness/sample.h"

void suite_interpolation_planes(void);

static struct test_canvas canvas;
static int32_t pixels;

static struct etch_triangle setup_of(const struct test_sample *s)
{
    const struct etch_point_q8 v[3] = {{s->shape.x[0], s->shape.y[0]},
                                       {s->shape.x[1], s->shape.y[1]},
                                       {s->shape.x[2], s->shape.y[2]}};
    struct etch_triangle t;

    CHECK(etch_triangle_setup(&t, v));
    return t;
}

/* |got - exact| <= (x + y + 1) / 2 units, where a value just below 0 has wrapped round. */
static bool plane_ok(const struct test_sample *s, int32_t x, int32_t y, uint32_t got,
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
        struct test_sample s;
        struct etch_triangle t;
        struct etch_plane plane;
        uint32_t value[3];
        int k;

        test_sample_make(&s, &canvas, i, &seed);
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
                if (!CHECK(
                        plane_ok(&s, x, y, etch_plane_at(&plane, (int16_t)x, (int16_t)y), value)))
                    test_sample_note(&s, x, y);
            }
        }
    }
}

/* What the user's function is told, checked on the spot. */
struct weights_check {
    const struct test_sample *sample;
    uint8_t order[3]; /* as sorted: the bound is for the first two */
};

static bool weight_ok(const struct test_sample *s, int32_t x, int32_t y, uint32_t b, uint8_t vertex,
                      uint32_t times)
{
    uint32_t value[3] = {0, 0, 0};

    value[vertex] = 65536;
    return b <= 65536 && test_sample_within(b, oracle_triangle_value(&s->exact, x, y, value),
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
        test_sample_note(c->sample, x, y);
    return TEST_INK;
}

static void weights_sum_to_one_and_keep_their_bound(void)
{
    uint32_t seed = 45;
    int32_t i, x, y;

    for (i = 0; i < TEST_COUNT(10000) && !test_failed(); i++) {
        const struct etch_rect *clip = &canvas.surface.clip;
        struct test_sample s;
        const struct etch_vertex *const v[3] = {&s.vertex[0], &s.vertex[1], &s.vertex[2]};
        struct weights_check c = {&s, {0, 1, 2}};
        int32_t wrong = 0;

        test_sample_make(&s, &canvas, i, &seed);
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

void suite_interpolation_planes(void)
{
    pixels = 0;
    RUN(planes_keep_their_bound);
    RUN(weights_sum_to_one_and_keep_their_bound);
    test_print_count("", pixels, " pixels against exact rationals, none beyond its bound");
}
