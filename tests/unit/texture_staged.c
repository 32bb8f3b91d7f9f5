/* tests/unit: textures through whole pipelines: blits of one texel a pixel are identities in every
 * format, filter, wrap and environment; alpha of the texture decides tests and blending; strips
 * and clips change nothing, with mipmaps too. */
#include "core/draw/staged.h"
#include "core/fragment/blend.h"
#include "core/fragment/mipmap.h"
#include "core/fragment/sampler.h"
#include "core/fragment/source_blocks.h"
#include "core/fragment/test.h"
#include "core/fragment/write.h"
#include "tests/harness/canvas.h"
#include "tests/harness/shapes.h"
#include "tests/oracle/sampler.h"

void suite_texture_staged(void);

static struct test_canvas canvas;

static uint16_t colors[2048], palette[256];
static uint8_t bytes[2048], alpha[2048];

static const struct etch_image formats[] = {
    {etch_texels_rgb565, NULL, colors, NULL, NULL, 0, 0, 0},
    {etch_texels_rgb565, etch_texels_mask, colors, NULL, alpha, 0, 0, 0},
    {etch_texels_index8, etch_texels_alpha8, bytes, palette, alpha, 0, 0, 0},
    {etch_texels_index4, NULL, bytes, palette, NULL, 0, 0, 0}};

static void fill(uint32_t *seed)
{
    int32_t i;

    for (i = 0; i < 2048; i++) {
        colors[i] = (uint16_t)(test_random(seed) & 0xFFFF);
        bytes[i] = (uint8_t)(test_random(seed) & 0xFF);
        alpha[i] = (uint8_t)(test_random(seed) & 0xFF);
    }
    for (i = 0; i < 256; i++)
        palette[i] = (uint16_t)(test_random(seed) & 0xFFFF);
}

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
        struct etch_image image = formats[format];
        int32_t wrong = 0;

        fill(&seed);
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
        struct etch_image image = formats[0];
        int32_t wrong = 0;

        fill(&seed);
        for (x = 0; x < 2048; x++)
            colors[x] &= 15 << 11 | 31 << 5 | 15;
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
    struct etch_image image = formats[1];
    uint32_t seed = 103;
    int32_t i, x, y;

    image.width = image.stride = 30;
    image.height = 20;
    (void)etch_sampler_init(&sampler, &image, etch_filter_nearest, etch_texels_clamp);
    for (i = 0; i < 2; i++) {
        const struct etch_pipeline pipeline = {varyings, i == 0 ? tested : blended,
                                               etch_kernel_staged};
        int32_t wrong = 0;

        fill(&seed);
        for (x = 0; x < 2048; x++)
            alpha[x] = (uint8_t)(i == 0 ? 120 + x % 16 : x % 2 * 255);
        test_canvas_open(&canvas, (struct etch_rect){0, 0, 30, 20});
        draw_quad(&pipeline, 0, 0, 0, 0, 30, 20);
        for (y = 0; y < 20; y++) {
            for (x = 0; x < 30; x++) {
                const bool kept = alpha[y * 30 + x] >= 128;

                wrong += test_canvas_at(&canvas, x, y) !=
                         (kept ? colors[y * 30 + x] : TEST_BACKGROUND);
            }
        }
        CHECK_EQ(wrong, 0);
    }
}

/* ---- strips and clips ------------------------------------------------------------------------ */

struct scene {
    struct etch_texture_vertex v[3];
    const struct etch_mipmap *mipmap;
    etch_stage_function *source;
    etch_stage_function *environment;
    etch_texel_filter *filter;
    etch_texel_wrap *wrap;
    bool perspective;
};

static void draw_scene(const struct scene *s)
{
    static etch_varying *const parallel[] = {etch_varying_color, etch_varying_alpha,
                                             etch_varying_texture, NULL};
    static etch_varying *const perspective[] = {etch_varying_color, etch_varying_alpha,
                                                etch_varying_texture_perspective, NULL};
    struct etch_sampler sampler;
    const struct etch_stage stages[] = {{etch_source_color, NULL}, {etch_source_alpha, NULL},
                                        {s->source, NULL},         {s->environment, &sampler},
                                        {etch_stage_read, NULL},   {etch_stage_blend_alpha, NULL},
                                        {etch_stage_write, NULL},  {NULL, NULL}};
    const struct etch_pipeline pipeline = {s->perspective ? perspective : parallel, stages,
                                           etch_kernel_staged};
    const struct etch_texture_vertex *const v[3] = {&s->v[0], &s->v[1], &s->v[2]};
    const uint8_t level = etch_mipmap_level(s->mipmap, v);
    struct etch_texture_vertex out[3];
    const struct etch_vertex *const plain[3] = {&out[0].at, &out[1].at, &out[2].at};
    struct etch_staged_planes planes;
    int i;

    for (i = 0; i < 3; i++)
        etch_mipmap_vertex(&out[i], v[i], s->mipmap, level);
    (void)etch_sampler_init(&sampler, &s->mipmap->level[level], s->filter, s->wrap);
    etch_triangle_staged(&canvas.surface, plain, &pipeline, &planes);
}

static void strips_and_clips_change_nothing(void)
{
    static etch_stage_function *const sources[] = {
        etch_source_texture, etch_source_texture_perspective, etch_source_texture_blocks8,
        etch_source_texture_blocks16};
    static etch_stage_function *const environments[] = {
        etch_stage_texture_replace, etch_stage_texture_modulate, etch_stage_texture_decal};
    static const struct etch_rect window = {100, 50, 164, 80};
    static uint16_t whole[30][64], small[700];
    static uint8_t small_alpha[700];
    uint32_t seed = 104;
    int32_t i, k, x, y;

    for (i = 0; i < TEST_COUNT(600) && !test_failed(); i++) {
        struct etch_image image = formats[i % 4];
        struct etch_mipmap mipmap;
        struct scene s;
        struct test_triangle t;
        int32_t wrong = 0;

        s.mipmap = &mipmap;
        s.source = sources[i / 4 % 4];
        s.environment = environments[i / 16 % 3];
        s.filter = i / 2 % 2 == 0 ? etch_filter_nearest : etch_filter_linear;
        s.wrap = wraps[i / 3 % 3].wrap;
        s.perspective = i / 4 % 4 != 0;
        fill(&seed);
        image.width = image.stride = (uint16_t)test_range(&seed, 1, 32);
        image.height = (uint16_t)test_range(&seed, 1, 32);
        CHECK_EQ(etch_mipmap_build(&mipmap, &image, small, small_alpha, 700), ETCH_OK);
        test_triangle_make(&t, (enum test_triangle_kind)(i % TEST_TRIANGLE_KINDS), window, &seed);
        for (k = 0; k < 3; k++) {
            s.v[k] = vertex_at(0, 0, test_range(&seed, -200, 200), test_range(&seed, -200, 200));
            s.v[k].at.x_q8 = t.x[k];
            s.v[k].at.y_q8 = t.y[k];
            s.v[k].at.a = (uint8_t)test_range(&seed, 0, 255);
            s.v[k].at.g = (uint8_t)test_range(&seed, 0, 255);
            s.v[k].w = (uint32_t)test_range(&seed, 1, 20);
        }
        test_canvas_open(&canvas, window);
        draw_scene(&s);
        for (y = 0; y < 30; y++)
            for (x = 0; x < 64; x++)
                whole[y][x] = test_canvas_at(&canvas, x + 100, y + 50);
        for (k = 0; k < 3; k++) { /* some rows, some columns, a part of both */
            const int16_t left = (int16_t)(k == 0 ? 0 : test_range(&seed, 0, 54));
            const int16_t above = (int16_t)(k == 1 ? 0 : test_range(&seed, 0, 22));
            const struct etch_rect part = {(int16_t)(100 + left), (int16_t)(50 + above),
                                           (int16_t)(k == 0 ? 164 : 110 + left),
                                           (int16_t)(k == 1 ? 80 : 58 + above)};

            test_canvas_open(&canvas, part);
            draw_scene(&s);
            for (y = part.y0; y < part.y1; y++)
                for (x = part.x0; x < part.x1; x++)
                    wrong += test_canvas_at(&canvas, x, y) != whole[y - 50][x - 100];
            CHECK_ONCE(&canvas);
        }
        if (!CHECK_EQ(wrong, 0))
            test_note("case", i);
    }
}

void suite_texture_staged(void)
{
    RUN(blits_one_to_one_are_identities);
    RUN(linear_blits_are_identities);
    RUN(alpha_tests_and_blends);
    RUN(strips_and_clips_change_nothing);
}
