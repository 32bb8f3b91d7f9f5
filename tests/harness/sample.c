/* tests/harness: seeded triangles with colours and depths. Called by the suites of interpolation.
 * See sample.h. */
#include "sample.h"

/* At the origin, on a usual screen, where x + y passes 2046, and in the far corner. */
static const struct etch_rect windows[] = {
    {0, 0, 40, 30}, {280, 200, 320, 230}, {1010, 1010, 1050, 1040}, {32727, 32737, 32767, 32767}};

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

void test_sample_make_kind(struct test_sample *s, struct test_canvas *canvas,
                           enum test_triangle_kind kind, int32_t i, uint32_t *seed)
{
    int k;

    test_triangle_make(&s->shape, kind, windows[i % 4], seed);
    oracle_triangle_make(&s->exact, s->shape.x, s->shape.y);
    for (k = 0; k < 3; k++) {
        s->vertex[k].x_q8 = s->shape.x[k];
        s->vertex[k].y_q8 = s->shape.y[k];
    }
    random_color(s->vertex, seed);
    random_depth(s->vertex, seed);
    test_canvas_open(canvas, windows[i % 4]);
}

void test_sample_make(struct test_sample *s, struct test_canvas *canvas, int32_t i, uint32_t *seed)
{
    test_sample_make_kind(s, canvas, (enum test_triangle_kind)(i % TEST_TRIANGLE_KINDS),
                          i / TEST_TRIANGLE_KINDS, seed);
}

void test_sample_note(const struct test_sample *s, int32_t x, int32_t y)
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

/* All times area * unit * 2^17: at most 2^17 * 2^16 * 2^48 * 2^16 = 2^97. */
bool test_sample_within(uint32_t got, struct wide value, uint64_t area, uint32_t unit,
                        uint32_t bound)
{
    const struct wide mine = wide_scale(wide_product(area, got), unit);
    const struct wide allowed = wide_scale(wide_product(area, unit), bound);

    return wide_at_most(wide_scale(wide_distance(mine, value), UINT32_C(1) << 17), allowed);
}
