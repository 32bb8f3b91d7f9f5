/* tests/unit: depth in a floating layout, every pixel against exact rationals. */
#include "core/draw/inverse.h"
#include "tests/harness/canvas.h"
#include "tests/harness/sample.h"

void suite_inverse(void);

#define FAR UINT32_C(0xFFFF0000)

static struct test_canvas canvas;
static int32_t pixels, near_bound;

/* 65535.0 - z, with z of 15.0 and more. */
static uint32_t distance_of(uint32_t z_q16)
{
    return z_q16 > FAR                    ? 0
           : z_q16 < UINT32_C(0x000F0000) ? FAR - UINT32_C(0x000F0000)
                                          : FAR - z_q16;
}

/* The q, times 2^31, whose code is code_q1 / 2: with e and m of the code, 2^e (1 + m / 4096). */
static uint64_t value_of(uint32_t code_q1)
{
    return ((UINT64_C(4096) + code_q1 % 4096) << 19) << code_q1 / 4096;
}

static uint8_t leading_zeros(uint32_t v)
{
    uint8_t n = 0;

    while (n < 32 && (v << n) >> 31 == 0)
        n++;
    return n;
}

/* Whether the depth is the code nearest to some q within 1024 / 2^up units of the exact one, or
 * beyond x + y = 2046 within (x + y + 1) / 2 of them: q 2^31 area of the ends of its step, moved by
 * that. */
static bool depth_ok(const struct test_sample *s, int32_t x, int32_t y, uint16_t depth)
{
    const uint64_t area = (uint64_t)s->exact.area;
    const uint32_t q[3] = {distance_of(s->vertex[0].z_q16), distance_of(s->vertex[1].z_q16),
                           distance_of(s->vertex[2].z_q16)};
    const struct wide exact = wide_scale(oracle_triangle_value(&s->exact, x, y, q), UINT32_C(1)
                                                                                        << 31);
    const uint8_t zeros = leading_zeros(q[0] | q[1] | q[2] | 1);
    const uint32_t code = 65535U - depth, sum = (uint32_t)(x + y);
    const uint64_t off = (uint64_t)(sum <= 2046 ? 1024 : (sum + 1) / 2)
                         << (zeros == 0 ? 31 : 32 - zeros);
    const uint64_t low = code == 0 ? 0 : value_of(2 * code - 1);
    const uint64_t high = code == 0 ? value_of(1) : value_of(2 * code + 1);
    const struct wide most = wide_sum(wide_product(area, high), wide_product(area, off));

    if (sum <= 2046 &&
        !wide_at_most(exact, wide_sum(wide_product(area, high), wide_product(area, off / 10 * 9))))
        near_bound++;
    return (low <= off || wide_at_most(wide_product(area, low - off), exact)) &&
           wide_at_most(exact, most);
}

static void check_pixels(const struct test_sample *s)
{
    const struct etch_rect clip = canvas.surface.clip;

    for (int32_t y = clip.y0; y < clip.y1; y++) {
        for (int32_t x = clip.x0; x < clip.x1; x++) {
            const size_t at = etch_surface_index(&canvas.surface, (int16_t)x, (int16_t)y);

            if (!oracle_triangle_covers(&s->exact, x, y)) {
                CHECK(canvas.surface.depth[at] == UINT16_MAX);
                continue;
            }
            pixels++;
            if (!CHECK(depth_ok(s, x, y, canvas.surface.depth[at])))
                test_sample_note(s, x, y);
        }
    }
    CHECK_ONCE(&canvas);
}

static void draw(const struct test_sample *s, const uint8_t order[3],
                 etch_triangle_painter *painter, etch_kernel *kernel)
{
    const struct etch_vertex *const v[3] = {&s->vertex[order[0]], &s->vertex[order[1]],
                                            &s->vertex[order[2]]};

    painter(&canvas.surface, v, kernel);
}

/* Depths of every size: those of the sample, and far ones whose q is 2^-16 .. 2^16. */
static void far_away(struct test_sample *s, int32_t i, uint32_t *seed)
{
    for (int k = 0; i % 3 != 0 && k < 3; k++) {
        const uint32_t q = test_random(seed) >> (i % 3 == 1 ? i / 3 % 32 : test_range(seed, 0, 31));

        s->vertex[k].z_q16 = q > FAR ? 0 : FAR - q;
    }
}

static void every_code_keeps_its_bound(void)
{
    uint32_t seed = 81;

    for (int32_t i = 0; i < TEST_COUNT(12000) && !test_failed(); i++) {
        struct test_sample s;
        uint32_t hash;

        test_sample_make(&s, &canvas, i, &seed);
        far_away(&s, i, &seed);
        draw(&s, test_orders[0], etch_triangle_gouraud_inverse, etch_kernel_gouraud_inverse_lequal);
        check_pixels(&s);
        hash = test_canvas_hash(&canvas);
        draw(&s, test_orders[i % 6], etch_triangle_flat_inverse, etch_kernel_flat_inverse_less);
        CHECK_EQ(test_canvas_hash(&canvas), hash); /* nothing is nearer than itself */
        test_canvas_wipe(&canvas);
        for (int k = 0; k < 4; k++) { /* in quarters */
            const struct etch_rect w = canvas.surface.window;
            const int16_t mx = (int16_t)(w.x0 + 17), my = (int16_t)(w.y0 + 11);
            const struct etch_rect part = {k & 1 ? mx : w.x0, k & 2 ? my : w.y0, k & 1 ? w.x1 : mx,
                                           k & 2 ? w.y1 : my};

            etch_surface_clip(&canvas.surface, part);
            draw(&s, test_orders[i % 6], etch_triangle_gouraud_inverse,
                 etch_kernel_gouraud_inverse_lequal);
        }
        etch_surface_clip(&canvas.surface, canvas.surface.window);
        CHECK_EQ(test_canvas_hash(&canvas), hash);
    }
}

/* Constant depth: the code of every exponent, rounded to nearest, at every pixel. */
static void constants_are_rounded(void)
{
    static const int32_t x[3] = {0, 4096, 0}, y[3] = {0, 0, 4096};
    const struct etch_rect window = {0, 0, 8, 8};
    struct test_sample s;

    oracle_triangle_make(&s.exact, x, y);
    for (uint32_t e = 0; e < 32; e++) {
        for (uint32_t m = 0; m < 6; m++) {
            const uint32_t one = UINT32_C(1) << e, half_step = e >= 12 ? one >> 12 : 0;
            uint32_t q = m == 0   ? one
                         : m == 1 ? one + half_step
                         : m == 2 ? one + 3 * half_step
                         : m == 3 ? one + half_step * 2
                         : m == 4 ? one - 1
                                  : one + (one >> 1);

            if (q > FAR - UINT32_C(0x000F0000))
                q = FAR - UINT32_C(0x000F0000);
            test_canvas_open(&canvas, window);
            for (int i = 0; i < 3; i++)
                s.vertex[i] = (struct etch_vertex){x[i], y[i], FAR - q, 0, 0, 0, 255};
            draw(&s, test_orders[0], etch_triangle_flat_inverse, etch_kernel_flat_inverse_lequal);
            if (q != 0) {
                const uint64_t e2 = 31U - leading_zeros(q);
                const uint64_t exact = e2 * 2048 +
                                       (((uint64_t)(q - (UINT32_C(1) << e2)) * 4096 >> e2) + 1) / 2;

                CHECK_EQ(canvas.surface.depth[0], 65535 - exact);
            } else {
                CHECK_EQ(canvas.surface.depth[0], 65535);
            }
        }
    }
}

/* Two walls w / 2048 apart, near : far = 1 : 65535, are told apart at every distance but the last,
 * where linear depth keeps both in one step from 1/256 of the way on. */
static void walls_are_told_apart(void)
{
    const struct etch_rect window = {0, 0, 8, 8};
    const uint64_t far = UINT64_C(65535) << 16;

    for (uint32_t octave = 1; octave < 15; octave++) {
        uint16_t code[2], linear[2];

        for (uint32_t wall = 0; wall < 2; wall++) {
            const uint64_t w = (UINT64_C(65536) << octave) + ((UINT64_C(32) << octave) * wall);
            /* z = 65535.0 (1 - 1/w) / (1 - 1/far), rounded */
            const uint64_t z = (uint64_t)FAR * (w - 65536) / w * far / (far - 65536);
            struct test_sample s;

            for (int i = 0; i < 3; i++)
                s.vertex[i] = (struct etch_vertex){
                    i == 1 ? 4096 : 0, i == 2 ? 4096 : 0, (uint32_t)z, 0, 0, 0, 255};
            test_canvas_open(&canvas, window);
            draw(&s, test_orders[0], etch_triangle_flat_inverse, etch_kernel_flat_inverse_less);
            code[wall] = canvas.surface.depth[0];
            linear[wall] = (uint16_t)((z + 0x8000) >> 16);
        }
        CHECK(code[0] < code[1]);
        CHECK(octave == 5 || (linear[0] < linear[1]) == (octave < 5));
    }
}

void suite_inverse(void)
{
    pixels = near_bound = 0;
    RUN(every_code_keeps_its_bound);
    RUN(constants_are_rounded);
    RUN(walls_are_told_apart);
    test_print_count("", pixels, " codes of depth within their bound of exact rationals");
    test_print_count("  ", near_bound, " of them within a tenth of it");
}
