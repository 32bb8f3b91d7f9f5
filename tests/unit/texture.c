/* tests/unit: textures: what etch_texture_init takes, the reciprocal, blits that are identities,
 * and that nothing outside the texture's memory is ever read. */
#include "core/draw/texture.h"
#include "core/fragment/texture.h"
#include "tests/harness/canvas.h"
#include "tests/harness/shapes.h"
#include "tests/oracle/wide.h"

void suite_texture(void);

static struct test_canvas canvas;

static void init_takes_powers_of_two(void)
{
    static const uint16_t texels[1];
    static const struct {
        uint16_t width, height;
        int8_t width_bits, height_bits; /* -1: refused */
    } sizes[] = {{1, 1, 0, 0},      {64, 32, 6, 5},       {4096, 16, 12, 4}, {256, 256, 8, 8},
                 {1, 32768, 0, 15}, {2, 32768, 1, 15},    {4, 32768, -1, 0}, {8192, 1, -1, 0},
                 {512, 256, -1, 0}, {0, 4, -1, 0},        {4, 0, -1, 0},     {3, 4, -1, 0},
                 {4, 65535, -1, 0}, {32768, 32768, -1, 0}};
    struct etch_texture t = {NULL, 77, 78};
    size_t i;

    CHECK_EQ(etch_texture_init(&t, NULL, 4, 4), ETCH_EINVAL);
    for (i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        const bool ok = sizes[i].width_bits >= 0;

        t.width_bits = 77;
        CHECK_EQ(etch_texture_init(&t, texels, sizes[i].width, sizes[i].height),
                 ok ? ETCH_OK : ETCH_EINVAL);
        CHECK_EQ(t.width_bits, ok ? sizes[i].width_bits : 77);
        if (ok)
            CHECK(t.height_bits == sizes[i].height_bits && t.texels == texels);
    }
}

/* r d is 2^62 within 2^-27 of it. */
static void check_reciprocal(uint32_t d)
{
    const int32_t r = etch_reciprocal_q62(d);
    const uint64_t product = (uint64_t)(uint32_t)r * d;

    const uint64_t one = UINT64_C(1) << 62, off = product < one ? one - product : product - one;

    if (!CHECK(r > 0 && off <= UINT64_C(1) << 35))
        test_note("d", d);
}

static void reciprocal_keeps_its_bound(void)
{
    uint32_t seed = 51, i;

    for (i = 0; i < 32; i++) { /* both ends of every 32nd of the range */
        check_reciprocal((32 + i) << 26);
        check_reciprocal(((32 + i) << 26) + ((UINT32_C(1) << 26) - 1));
    }
    for (i = 0; i < (uint32_t)TEST_COUNT(300000); i++)
        check_reciprocal(test_random(&seed) | UINT32_C(0x80000000));
}

/* Texels that say their own index. */
static uint16_t texels[65536];

static struct etch_texture numbered(uint8_t width_bits, uint8_t height_bits)
{
    const struct etch_texture t = {texels, width_bits, height_bits};
    uint32_t i;

    for (i = 0; i < UINT32_C(1) << (width_bits + height_bits); i++)
        texels[i] = (uint16_t)i;
    return t;
}

static struct etch_texture_vertex vertex_at(int32_t x, int32_t y, int32_t u, int32_t v)
{
    const struct etch_texture_vertex t = {
        {x * 256, y * 256, UINT32_C(5) << 16, 0, 0, 0, 255}, u * 65536, v * 65536, 7};

    return t;
}

/* A quad whose texels are as large as pixels, by every painter. */
static void draw_quad(const struct etch_texture *t, int32_t x, int32_t y, int32_t u, int32_t v,
                      int32_t w, int32_t h, int painter)
{
    const struct etch_texture_vertex q[4] = {vertex_at(x, y, u, v), vertex_at(x + w, y, u + w, v),
                                             vertex_at(x, y + h, u, v + h),
                                             vertex_at(x + w, y + h, u + w, v + h)};
    const struct etch_texture_vertex *const a[3] = {&q[0], &q[1], &q[2]};
    const struct etch_texture_vertex *const b[3] = {&q[3], &q[1], &q[2]};
    const struct etch_texture_vertex *const *const half[2] = {a, b};
    const struct etch_surface *const s = &canvas.surface;
    int i;

    for (i = 0; i < 2; i++) {
        switch (painter) {
        case 0: etch_triangle_texture(s, half[i], t, etch_kernel_texture); break;
        case 1: etch_triangle_texture_depth(s, half[i], t, etch_kernel_texture_less); break;
        case 2: etch_triangle_texture_depth(s, half[i], t, etch_kernel_texture_lequal); break;
        case 3: etch_triangle_perspective(s, half[i], t, &etch_perspective); break;
        default: etch_triangle_perspective_depth(s, half[i], t, &etch_perspective_less); break;
        }
    }
}

/* Every texel in its place, wherever the quad lies and however often it repeats. */
static void blits_one_to_one_are_identities(void)
{
    uint32_t seed = 52;
    int32_t i, x, y;

    for (i = 0; i < TEST_COUNT(500) && !test_failed(); i++) {
        const int32_t left = test_range(&seed, 0, 3) * test_range(&seed, 0, 5000);
        const struct etch_rect window = {(int16_t)left, 0, (int16_t)(left + 40), 30};
        const uint8_t wide = (uint8_t)test_range(&seed, 0, 8),
                      high = (uint8_t)test_range(&seed, 0, 8);
        const struct etch_texture t = numbered(wide, high);
        const int32_t qx = left + test_range(&seed, -50, 50), qy = test_range(&seed, -50, 50);
        const int32_t w = test_range(&seed, 1, 100), h = test_range(&seed, 1, 100);
        const int32_t u = test_range(&seed, -300, 300), v = test_range(&seed, -300, 300);
        int32_t wrong = 0;

        test_canvas_open(&canvas, window);
        draw_quad(&t, qx, qy, u, v, w, h, i % 5);
        for (y = 0; y < 30; y++) {
            for (x = left; x < left + 40; x++) {
                const bool in = x >= qx && x < qx + w && y >= qy && y < qy + h;
                const uint32_t column = (uint32_t)(u + x - qx) & ((UINT32_C(1) << wide) - 1);
                const uint32_t row = (uint32_t)(v + y - qy) & ((UINT32_C(1) << high) - 1);

                wrong += test_canvas_at(&canvas, x, y) !=
                         (in ? (uint16_t)(row << wide | column) : TEST_BACKGROUND);
            }
        }
        if (!CHECK_EQ(wrong, 0)) {
            test_note("case", i);
            test_note("width bits", wide);
        }
        CHECK_ONCE(&canvas);
    }
}

/* Kernels given planes of any bits, over a texture with nothing round it: the sanitizer sees a read
 * outside, and a colour that is none of the texture's fails here. */
static void no_plane_leads_outside_the_texture(void)
{
    static uint16_t small[8];
    static etch_kernel *const affine[] = {etch_kernel_texture, etch_kernel_texture_less};
    static etch_kernel *const divided[] = {etch_kernel_perspective,
                                           etch_kernel_perspective_less,
                                           etch_kernel_perspective_lequal,
                                           etch_kernel_perspective_exact,
                                           etch_kernel_perspective_exact_less,
                                           etch_kernel_perspective_exact_lequal};
    const struct etch_rect window = {480, 0, 544, 2};
    const struct etch_run runs[2] = {{480, 544}, {485, 530}};
    uint32_t seed = 53;
    int32_t i, x, k;

    for (k = 0; k < 8; k++)
        small[k] = 0xAB00;
    for (i = 0; i < TEST_COUNT(3000) && !test_failed(); i++) {
        struct etch_texture_paint a = {
            {affine[i % 2]}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {small, 6, 8}};
        struct etch_perspective_paint p = {
            {divided[i % 6]},
            {0, 0, 0},
            {{{0, 0, 0}, 0, 0, 0, 0, 0, 0}, {{0, 0, 0}, 0, 0, 0, 0, 0, 0}, {0, 0, 0}, 1, true},
            {small, 6, 8},
            2};
        struct etch_perspective_axis *const axes[2] = {&p.coordinates.u, &p.coordinates.v};
        struct etch_plane *const planes[5] = {&a.u, &a.v, &p.coordinates.u.numerator,
                                              &p.coordinates.v.numerator,
                                              &p.coordinates.denominator};
        int32_t wrong = 0;

        for (k = 0; k < 5; k++) {
            planes[k]->origin = test_random(&seed);
            planes[k]->dx = test_random(&seed) >> test_range(&seed, 0, 31);
            planes[k]->dy = test_random(&seed);
        }
        for (k = 0; k < 2; k++) {
            axes[k]->middle = test_random(&seed);
            axes[k]->least = -test_range(&seed, 0, INT32_MAX);
            axes[k]->most = test_range(&seed, 0, INT32_MAX);
            axes[k]->least_q12 = axes[k]->least / 16;
            axes[k]->most_q12 = axes[k]->most / 16;
            axes[k]->exponent = (int8_t)test_range(&seed, -31, -1);
        }
        p.coordinates.least = test_range(&seed, 1, 1 << test_range(&seed, 0, 29));
        test_canvas_open(&canvas, window);
        a.paint.kernel(&canvas.surface, 0, runs, 2, &a.paint);
        p.paint.kernel(&canvas.surface, 0, runs, 2, &p.paint);
        for (x = 480; x < 544; x++)
            wrong += test_canvas_at(&canvas, x, 0) != 0xAB00 ||
                     (test_canvas_at(&canvas, x, 1) != 0xAB00 && x >= 485 && x < 530);
        CHECK_EQ(wrong, 0);
    }
}

void suite_texture(void)
{
    RUN(init_takes_powers_of_two);
    RUN(reciprocal_keeps_its_bound);
    RUN(blits_one_to_one_are_identities);
    RUN(no_plane_leads_outside_the_texture);
}
