/* tests/unit: that stated bounds are tight. For each mode an input whose error beyond the
 * unavoidable 1/2 of rounding comes within a tenth of what is stated beyond 1/2: found by search,
 * drawn here, and compared with exact rationals. A better arithmetic makes these fail: then the
 * statement is to be sharpened. */
#include "core/base/texture.h"
#include "core/base/unit.h"
#include "core/draw/dither.h"
#include "core/draw/inverse.h"
#include "core/draw/triangle.h"
#include "core/fragment/flat.h"
#include "core/fragment/gouraud.h"
#include "tests/harness/canvas.h"
#include "tests/harness/sample.h"

void suite_tight(void);

static struct test_canvas canvas;

/* A pixel and the triangle round it; `value` is a channel or a depth. */
struct extreme {
    int32_t x[3], y[3];
    uint32_t value[3];
    int16_t px, py;
};

static void make(struct test_sample *s, const struct extreme *e)
{
    const struct etch_rect window = {(int16_t)(e->px - 4), (int16_t)(e->py - 4),
                                     (int16_t)(e->px + 4), (int16_t)(e->py + 4)};

    oracle_triangle_make(&s->exact, e->x, e->y);
    for (int i = 0; i < 3; i++)
        s->vertex[i] = (struct etch_vertex){
            e->x[i], e->y[i], e->value[i], 0, (uint8_t)(e->value[i] & 255), 0, 255};
    test_canvas_open(&canvas, window);
}

static void draw(const struct test_sample *s, etch_triangle_painter *painter, etch_kernel *kernel)
{
    const struct etch_vertex *const v[3] = {&s->vertex[0], &s->vertex[1], &s->vertex[2]};

    painter(&canvas.surface, v, kernel);
}

/* |got - value / (area unit)| is more than 1/2 + nearly, and at most 1/2 + beyond, in 2^-17. */
static void check_tight(const struct test_sample *s, uint32_t got, struct wide value, uint32_t unit,
                        uint32_t beyond, uint32_t nearly)
{
    const uint64_t area = (uint64_t)s->exact.area;

    CHECK(test_sample_within(got, value, area, unit, 65536 + beyond));
    CHECK(!test_sample_within(got, value, area, unit, 65536 + nearly));
}

/* Linear depth, 1/2 + 1/64 unit where x + y <= 2046: the exact planes of raster/plane.h, 1023 /
 * 2^16 off. */
static void depth_is_tight(void)
{
    static const struct extreme e = {{265598, 265598, -6317054},
                                     {259199, 7641654, 263375},
                                     {UINT32_C(0xFFFF0000), 0, UINT32_C(0xFFFF0000)},
                                     1010,
                                     1014};
    struct test_sample s;

    make(&s, &e);
    draw(&s, etch_triangle_flat_depth, etch_kernel_flat_lequal);
    check_tight(&s, canvas.surface.depth[etch_surface_index(&canvas.surface, e.px, e.py)],
                oracle_triangle_value(&s.exact, e.px, e.py, e.value), 65536, 2048, 2048 * 9 / 10);
}

/* Colour, 1/2 + 3/2048 step: a sliver as long as the planes of a near triangle may be of, full
 * scale across it, and a pixel that falls between two steps. */
static void color_is_tight(void)
{
    static const struct extreme e = {
        {12072, 76925, 76930}, {11821, 76934, 76931}, {0, 255, 255}, 298, 298};
    const uint32_t value[3] = {e.value[0] * 63, e.value[1] * 63, e.value[2] * 63};
    struct test_sample s;

    make(&s, &e);
    draw(&s, etch_triangle_gouraud, etch_kernel_gouraud);
    check_tight(&s, test_canvas_at(&canvas, e.px, e.py) >> 5 & 63,
                oracle_triangle_value(&s.exact, e.px, e.py, value), 255, 192, 192 * 9 / 10);
}

/* What a painter hands over at (px, py). */
static uint32_t seen;
static int16_t seen_x, seen_y;

static void look(const struct etch_surface *surface, int16_t y0, const struct etch_run *runs,
                 uint8_t n, const struct etch_paint *paint)
{
    (void)surface, (void)y0, (void)runs, (void)n;
    seen = etch_plane_at(&((const struct etch_flat_depth_paint *)paint)->z, seen_x, seen_y);
}

/* Inverse depth: the code is that of a q 2^up within 1024 units of the exact one (here up = 0). */
static void inverse_depth_is_tight(void)
{
    static const struct extreme e = {
        {267390, 267391, 258502},
        {264575, -4965708, 252698},
        {UINT32_C(2750338082), UINT32_C(1413462647), UINT32_C(3444601391)},
        1036,
        1010};
    const uint32_t far = UINT32_C(0xFFFF0000);
    const uint32_t q[3] = {far - e.value[0], far - e.value[1], far - e.value[2]};
    struct test_sample s;

    make(&s, &e);
    seen_x = e.px, seen_y = e.py;
    draw(&s, etch_triangle_flat_inverse, look);
    const uint64_t area = (uint64_t)s.exact.area;
    const struct wide off = wide_distance(wide_product(area, seen - 0x8000),
                                          oracle_triangle_value(&s.exact, e.px, e.py, q));

    CHECK(wide_at_most(off, wide_product(area, 1024)));
    CHECK(!wide_at_most(off, wide_product(area, 1024 * 9 / 10)));
}

/* Reciprocals: 2^62 / d within 2^-27.9 of itself, at the d where Newton's iteration errs most (all
 * were tried), and 2^31 / sqrt(s), 2.42 units below to 0.93 above, likewise. */
static void reciprocals_are_tight(void)
{
    const uint32_t d = UINT32_C(4281860304), below = UINT32_C(1081901056),
                   above = UINT32_C(1341358079);
    const uint64_t one = UINT64_C(1) << 62;
    const uint64_t product = (uint64_t)(uint32_t)etch_reciprocal_q62(d) * d;
    const uint64_t r = etch_rsqrt_q31(below), q = etch_rsqrt_q31(above);

    CHECK(product < one && one - product <= (UINT64_C(1) << 35) / 1000 * 536);
    CHECK(one - product >= (UINT64_C(1) << 35) / 1000 * 530);
    /* 2^31 / sqrt(s) is above r + 2.4 and below r + 2.42: (100 r + 240)^2 s < 10^4 2^62 */
    CHECK(wide_at_most(wide_product((100 * r + 240) * (100 * r + 240), below),
                       wide_product(one, 10000)));
    CHECK(wide_at_most(wide_product(one, 10000),
                       wide_product((100 * r + 242) * (100 * r + 242), below)));
    CHECK(wide_at_most(wide_product(one, 10000),
                       wide_product((100 * q - 92) * (100 * q - 92), above)));
    CHECK(wide_at_most(wide_product((100 * q - 93) * (100 * q - 93), above),
                       wide_product(one, 10000)));
}

/* Ordered dithering: the mean of 8 x 8 pixels errs by the 1/128 that is stated at colours half
 * way between two thresholds; 8-bit colours come near that. */
static void blocks_are_tight(void)
{
    const struct etch_rect window = {0, 0, 8, 8};
    int32_t worst = 0;

    test_canvas_open(&canvas, window);
    for (int32_t c = 0; c < 256; c++) {
        const struct etch_vertex colored = {0, 0, 0, (uint8_t)c, 0, 0, 255};
        const struct etch_vertex right = {4096, 0, 0, 0, 0, 0, 255},
                                 down = {0, 4096, 0, 0, 0, 0, 255};
        const struct etch_vertex *const v[3] = {&colored, &right, &down};
        int32_t sum = 0, off;

        test_canvas_wipe(&canvas);
        etch_triangle_flat_dither(&canvas.surface, v, etch_kernel_gouraud_dither);
        for (int32_t i = 0; i < 64; i++)
            sum += test_canvas_at(&canvas, i % 8, i / 8) >> 11;
        off = sum * 255 - c * 31 * 64;
        off = off < 0 ? -off : off;
        worst = off > worst ? off : worst;
    }
    /* in 1 / (64 255): 127.5 is 1/128 */
    CHECK(worst <= 127 && worst >= 115);
}

void suite_tight(void)
{
    RUN(depth_is_tight);
    RUN(color_is_tight);
    RUN(inverse_depth_is_tight);
    RUN(reciprocals_are_tight);
    RUN(blocks_are_tight);
}
