/* tests/unit: textures through whole pipelines: blits of one texel a pixel are identities in every
 * format, filter, wrap and environment; alpha of the texture decides tests and blending.
 * Strips and clips: texture_staged_strips.c. */
#include "core/draw/staged.h"
#include "core/fragment/blend.h"
#include "core/fragment/sampler.h"
#include "core/fragment/test.h"
#include "core/fragment/write.h"
#include "tests/harness/canvas.h"
#include "tests/oracle/sampler.h"
#include "tests/unit/texel_parts.h"

void suite_texture_staged(void);

static struct test_canvas canvas;

static struct texels texels;

/* What stands in texel (x, y), by the image's own function, which the suite of samplers proves. */
static uint16_t color_at(const struct etch_image *image, int32_t x, int32_t y)
{
    const uint16_t column = (uint16_t)x, row = (uint16_t)y;
    uint16_t color;

    image->colors(&color, &column, &row, 1, image);
    return color;
}

static struct etch_texture_vertex vertex_at(int32_t x, int32_t y, int32_t u, int32_t v)
{
    const struct etch_texture_vertex t = {
        {x * 256, y * 256, UINT32_C(5) << 16, 255, 255, 255, 255}, u * 65536, v * 65536, 7};

    return t;
}

/* Two triangles, from (x, y) and (u, v) on, in white. */
static void draw_quad(const struct etch_pipeline *pipeline, int32_t x, int32_t y, int32_t u,
                      int32_t v, int32_t w, int32_t h)
{
    const struct etch_texture_vertex q[4] = {vertex_at(x, y, u, v), vertex_at(x + w, y, u + w, v),
                                             vertex_at(x, y + h, u, v + h),
                                             vertex_at(x + w, y + h, u + w, v + h)};
    const struct etch_vertex *const a[3] = {&q[0].at, &q[1].at, &q[2].at};
    const struct etch_vertex *const b[3] = {&q[3].at, &q[1].at, &q[2].at};
    struct etch_staged_planes planes;

    etch_triangle_staged(&canvas.surface, a, pipeline, &planes);
    etch_triangle_staged(&canvas.surface, b, pipeline, &planes);
}

static etch_varying *const varyings[] = {etch_varying_color, etch_varying_alpha,
                                         etch_varying_texture, NULL};

static const struct {
    etch_texel_wrap *wrap;
    enum oracle_wrap means;
} wraps[] = {{etch_texels_repeat, ORACLE_REPEAT},
             {etch_texels_clamp, ORACLE_CLAMP},
             {etch_texels_mirror, ORACLE_MIRROR}};

/* Every texel in its place, under a white fragment by modulate too; decal without alpha. */
static void blits_one_to_one_are_identities(void)
{
    static etch_stage_function *const environments[] = {
        etch_stage_texture_replace, etch_stage_texture_modulate, etch_stage_texture_decal};
    uint32_t seed = 101;
    int32_t i, x, y;

    for (i = 0; i < TEST_COUNT(432) && !test_failed(); i++) {
        const int32_t left = test_range(&seed, 0, 3) * test_range(&seed, 0, 5000);
        const struct etch_rect window = {(int16_t)left, 0, (int16_t)(left + 40), 30};
        const int32_t qx = left + test_range(&seed, -50, 50), qy = test_range(&seed, -50, 50);
        const int32_t w = test_range(&seed, 1, 100), h = test_range(&seed, 1, 100);
        const int32_t u = test_range(&seed, -300, 300), v = test_range(&seed, -300, 300);
        const int32_t wrap = i / 3 % 3, environment = i % 3, format = i / 9 % 4;
        struct etch_sampler sampler;
        const struct etch_stage stages[] = {
            {etch_source_color, NULL},   {etch_source_alpha, NULL},
            {etch_source_texture, NULL}, {environments[environment], &sampler},
            {etch_stage_write, NULL},    {NULL, NULL}};
        const struct etch_pipeline pipeline = {varyings, stages, etch_kernel_staged};
        struct etch_image image = texels_image(&texels, format);
        int32_t wrong = 0;

        texels_fill(&texels, &seed);
        image.width = (uint16_t)test_range(&seed, 1, 45);
        image.height = (uint16_t)test_range(&seed, 1, 45);
        image.stride = image.width;
        if (environment == 2)
            image.alphas = NULL;
        CHECK_EQ(etch_sampler_init(&sampler, &image, etch_filter_nearest, wraps[wrap].wrap),
                 ETCH_OK);
        test_canvas_open(&canvas, window);
        draw_quad(&pipeline, qx, qy, u, v, w, h);
        for (y = 0; y < 30; y++) {
            for (x = left; x < left + 40; x++) {
                const bool in = x >= qx && x < qx + w && y >= qy && y < qy + h;
                const int32_t column = oracle_wrapped(wraps[wrap].means, u + x - qx, image.width);
                const int32_t row = oracle_wrapped(wraps[wrap].means, v + y - qy, image.height);

                wrong += test_canvas_at(&canvas, x, y) !=
                         (in ? color_at(&image, column, row) : TEST_BACKGROUND);
            }
        }
        if (!CHECK_EQ(wrong, 0)) {
            test_note("case", i);
            test_note("width", image.width);
        }
        CHECK_ONCE(&canvas);
    }
}

/* Linear on texels as large as pixels, each channel within half its range of its neighbours: with
 * coordinates within 1/64 texel, the texel itself. */
static void linear_blits_are_identities(void)
{
    uint32_t seed = 102;
    int32_t i, x, y;

    for (i = 0; i < TEST_COUNT(100) && !test_failed(); i++) {
        struct etch_sampler sampler;
        const struct etch_stage stages[] = {{etch_source_texture, NULL},
                                            {etch_stage_texture_replace, &sampler},
                                            {etch_stage_write, NULL},
                                            {NULL, NULL}};
        const struct etch_pipeline pipeline = {varyings, stages, etch_kernel_staged};
        const int32_t u = test_range(&seed, -30, 30), v = test_range(&seed, -30, 30);
        struct etch_image image = texels_image(&texels, 0);
        int32_t wrong = 0;

        texels_fill(&texels, &seed);
        for (x = 0; x < 2048; x++)
            texels.colors[x] &= 15 << 11 | 31 << 5 | 15;
        image.width = image.stride = (uint16_t)test_range(&seed, 1, 45);
        image.height = (uint16_t)test_range(&seed, 1, 45);
        (void)etch_sampler_init(&sampler, &image, etch_filter_linear, etch_texels_repeat);
        test_canvas_open(&canvas, (struct etch_rect){0, 0, 40, 30});
        draw_quad(&pipeline, 0, 0, u, v, 40, 30);
        for (y = 0; y < 30; y++)
            for (x = 0; x < 40; x++)
                wrong += test_canvas_at(&canvas, x, y) !=
                         color_at(&image, oracle_wrapped(ORACLE_REPEAT, u + x, image.width),
                                  oracle_wrapped(ORACLE_REPEAT, v + y, image.height));
        if (!CHECK_EQ(wrong, 0))
            test_note("case", i);
    }
}

/* Replace hands the texture's alpha on: tests keep and drop by it, blending leaves a pixel at 0 and
 * writes it at 255. */
static void alpha_tests_and_blends(void)
{
    static const struct etch_alpha_test half = {128};
    struct etch_sampler sampler;
    const struct etch_stage tested[] = {{etch_source_alpha, NULL},
                                        {etch_source_texture, NULL},
                                        {etch_stage_texture_replace, &sampler},
                                        {etch_stage_alpha_gequal, &half},
                                        {etch_stage_write, NULL},
                                        {NULL, NULL}};
    const struct etch_stage blended[] = {{etch_source_alpha, NULL},
                                         {etch_source_texture, NULL},
                                         {etch_stage_texture_replace, &sampler},
                                         {etch_stage_read, NULL},
                                         {etch_stage_blend_alpha, NULL},
                                         {etch_stage_write, NULL},
                                         {NULL, NULL}};
    struct etch_image image = texels_image(&texels, 1);
    uint32_t seed = 103;
    int32_t i, x, y;

    image.width = image.stride = 30;
    image.height = 20;
    (void)etch_sampler_init(&sampler, &image, etch_filter_nearest, etch_texels_clamp);
    for (i = 0; i < 2; i++) {
        const struct etch_pipeline pipeline = {varyings, i == 0 ? tested : blended,
                                               etch_kernel_staged};
        int32_t wrong = 0;

        texels_fill(&texels, &seed);
        for (x = 0; x < 2048; x++)
            texels.alpha[x] = (uint8_t)(i == 0 ? 120 + x % 16 : x % 2 * 255);
        test_canvas_open(&canvas, (struct etch_rect){0, 0, 30, 20});
        draw_quad(&pipeline, 0, 0, 0, 0, 30, 20);
        for (y = 0; y < 20; y++) {
            for (x = 0; x < 30; x++) {
                const bool kept = texels.alpha[y * 30 + x] >= 128;

                wrong += test_canvas_at(&canvas, x, y) !=
                         (kept ? texels.colors[y * 30 + x] : TEST_BACKGROUND);
            }
        }
        CHECK_EQ(wrong, 0);
    }
}

void suite_texture_staged(void)
{
    RUN(blits_one_to_one_are_identities);
    RUN(linear_blits_are_identities);
    RUN(alpha_tests_and_blends);
}
