/* tests/unit: staged pixel work is that of the fused kernels bit for bit where both exist;
 * textures as their fused kernels; clips change nothing. */
#include "core/draw/shapes.h"
#include "core/draw/blend.h"
#include "core/draw/staged.h"
#include "core/draw/texture.h"
#include "core/draw/triangle.h"
#include "core/fragment/blend.h"
#include "core/fragment/blend_fused.h"
#include "core/fragment/flat.h"
#include "core/fragment/gouraud.h"
#include "core/fragment/sampler.h"
#include "core/fragment/test.h"
#include "core/fragment/texture.h"
#include "core/fragment/write.h"
#include "tests/harness/canvas.h"
#include "tests/harness/sample.h"

void suite_staged(void);

static struct test_canvas canvas;
static struct etch_staged_planes planes;

#define END                                                                                        \
    {                                                                                              \
        NULL, NULL                                                                                 \
    }

/* ---- the same as fused ------------------------------------------------------------------------ */

static etch_varying *const smooth_depth[] = {etch_varying_color, etch_varying_depth, NULL};
static etch_varying *const flat_depth[] = {etch_varying_flat, etch_varying_depth, NULL};

static const struct etch_stage smooth_lequal[] = {
    {etch_source_depth, NULL}, {etch_stage_depth_lequal, NULL}, {etch_stage_depth_write, NULL},
    {etch_source_color, NULL}, {etch_stage_write, NULL},        END};
static const struct etch_stage smooth_swapped[] = {
    {etch_source_color, NULL},      {etch_source_depth, NULL},        {etch_stage_depth_less, NULL},
    {etch_stage_depth_write, NULL}, {etch_stage_write_swapped, NULL}, END};
static const struct etch_stage flat_less[] = {
    {etch_source_flat, NULL},       {etch_source_depth, NULL}, {etch_stage_depth_less, NULL},
    {etch_stage_depth_write, NULL}, {etch_stage_write, NULL},  END};

/* The fade's alpha is that of vertex 0, which the test makes this. */
static struct etch_blend_constant fade;

#define BLENDED(name, source, alpha, blend, data, swapped)                                         \
    static const struct etch_stage name[] = {{source, NULL},                                       \
                                             {alpha, NULL},                                        \
                                             {etch_stage_read##swapped, NULL},                     \
                                             {blend, data},                                        \
                                             {etch_stage_write##swapped, NULL},                    \
                                             END};
BLENDED(flat_blended, etch_source_flat, etch_source_flat, etch_stage_blend_alpha, NULL, )
BLENDED(flat_blended_swapped, etch_source_flat, etch_source_flat, etch_stage_blend_alpha, NULL,
        _swapped)
BLENDED(smooth_blended, etch_source_color, etch_source_alpha, etch_stage_blend_alpha, NULL, )
BLENDED(smooth_blended_swapped, etch_source_color, etch_source_alpha, etch_stage_blend_alpha, NULL,
        _swapped)
BLENDED(smooth_faded, etch_source_color, etch_source_alpha, etch_stage_blend_constant, &fade, )
BLENDED(smooth_faded_swapped, etch_source_color, etch_source_alpha, etch_stage_blend_constant,
        &fade, _swapped)
static etch_varying *const smooth_alpha[] = {etch_varying_color, etch_varying_alpha, NULL};

static const struct {
    struct etch_pipeline staged;
    etch_triangle_painter *painter;
    etch_kernel *kernel;
} twins[] = {
    {{smooth_depth, smooth_lequal, etch_kernel_staged},
     etch_triangle_gouraud_depth,
     etch_kernel_gouraud_lequal},
    {{smooth_depth, smooth_swapped, etch_kernel_staged},
     etch_triangle_gouraud_depth,
     etch_kernel_gouraud_less_swapped},
    {{flat_depth, flat_less, etch_kernel_staged}, etch_triangle_flat_depth, etch_kernel_flat_less},
    {{flat_depth, flat_blended, etch_kernel_staged},
     etch_triangle_flat_blend,
     etch_kernel_flat_blend},
    {{flat_depth, flat_blended_swapped, etch_kernel_staged},
     etch_triangle_flat_blend,
     etch_kernel_flat_blend_swapped},
    {{smooth_alpha, smooth_blended, etch_kernel_staged},
     etch_triangle_gouraud_blend,
     etch_kernel_gouraud_blend},
    {{smooth_alpha, smooth_blended_swapped, etch_kernel_staged},
     etch_triangle_gouraud_blend,
     etch_kernel_gouraud_blend_swapped},
    {{smooth_alpha, smooth_faded, etch_kernel_staged},
     etch_triangle_gouraud_fade,
     etch_kernel_gouraud_fade},
    {{smooth_alpha, smooth_faded_swapped, etch_kernel_staged},
     etch_triangle_gouraud_fade,
     etch_kernel_gouraud_fade_swapped},
};

static void random_alpha(struct test_sample *s, uint32_t *seed)
{
    const int kind = test_range(seed, 0, 2);
    int k;

    for (k = 0; k < 3; k++)
        s->vertex[k].a = (uint8_t)(kind == 0   ? test_range(seed, 0, 255)
                                   : kind == 1 ? 255 * test_range(seed, 0, 1)
                                               : 17);
}

/* Every second sample on noise and a plane of depths that some pixels pass and some do not. */
static void prepare(const struct test_sample *s, int32_t i)
{
    const struct etch_rect c = canvas.surface.clip;
    uint32_t noise = (uint32_t)i + 1;
    int16_t x, y;

    test_canvas_wipe(&canvas);
    if (i % 2 != 0)
        etch_depth_clear(&canvas.surface, (uint16_t)(s->vertex[i % 3].z_q16 >> 16));
    for (y = c.y0; y < c.y1; y++)
        for (x = c.x0; x < c.x1; x++)
            canvas.surface.pixels[etch_surface_index(&canvas.surface, x, y)] =
                (uint16_t)(test_random(&noise) >> 16);
}

static void staged_is_fused(void)
{
    const int32_t count = sizeof twins / sizeof twins[0];
    uint32_t seed = 61;
    int32_t i, k;

    for (i = 0; i < TEST_COUNT(1000) && !test_failed(); i++) {
        for (k = 0; k < count; k++) {
            struct test_sample s;
            const struct etch_vertex *const v[3] = {&s.vertex[0], &s.vertex[1], &s.vertex[2]};
            uint32_t hash;

            test_sample_make(&s, &canvas, i, &seed);
            random_alpha(&s, &seed);
            fade.alpha = s.vertex[0].a;
            prepare(&s, i);
            twins[k].painter(&canvas.surface, v, twins[k].kernel);
            hash = test_canvas_hash(&canvas);
            prepare(&s, i);
            etch_triangle_staged(&canvas.surface, v, &twins[k].staged, &planes);
            if (!CHECK_EQ(test_canvas_hash(&canvas), hash))
                test_sample_note(&s, k, i);
            CHECK_INSIDE(&canvas);
        }
    }
}

/* ---- textures ----------------------------------------------------------------------------------- */

static const uint16_t texels[8 * 4] = {1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11,
                                       12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22,
                                       23, 24, 25, 26, 27, 28, 29, 30, 31, 32};
static const struct etch_sampler sampler = {{etch_texels_rgb565, NULL, texels, NULL, NULL, 8, 4, 8},
                                            etch_filter_nearest,
                                            etch_texels_repeat,
                                            etch_texels_repeat};

static etch_varying *const textured[] = {etch_varying_texture, NULL};
static etch_varying *const textured_perspective[] = {etch_varying_texture_perspective, NULL};
static const struct etch_stage replace[] = {{etch_source_texture, NULL},
                                            {etch_stage_texture_replace, &sampler},
                                            {etch_stage_write, NULL},
                                            END};
static const struct etch_stage replace_perspective[] = {{etch_source_texture_perspective, NULL},
                                                        {etch_stage_texture_replace, &sampler},
                                                        {etch_stage_write, NULL},
                                                        END};

static void give_texture(struct etch_texture_vertex out[3], const struct test_sample *s,
                         uint32_t *seed)
{
    int k;

    for (k = 0; k < 3; k++) {
        out[k].at = s->vertex[k];
        out[k].u = test_range(seed, -100 * 65536, 100 * 65536);
        out[k].v = test_range(seed, -100 * 65536, 100 * 65536);
        out[k].w = (uint32_t)test_range(seed, 1, 65535);
    }
    if (test_range(seed, 0, 3) == 0) /* what is off the frame may leave the range of 16.16 */
        out[test_range(seed, 0, 2)].u = INT32_MAX;
}

static void textures_in_perspective_are_the_exact_kernel(void)
{
    static const struct etch_pipeline staged = {textured_perspective, replace_perspective,
                                                etch_kernel_staged};
    struct etch_texture texture;
    uint32_t seed = 62;
    int32_t i;

    CHECK_EQ(etch_texture_init(&texture, texels, 8, 4), ETCH_OK);
    for (i = 0; i < TEST_COUNT(2000) && !test_failed(); i++) {
        struct etch_texture_vertex t[3];
        const struct etch_texture_vertex *const v[3] = {&t[0], &t[1], &t[2]};
        const struct etch_vertex *const plain[3] = {&t[0].at, &t[1].at, &t[2].at};
        struct test_sample s;
        uint32_t hash;

        test_sample_make(&s, &canvas, i, &seed);
        give_texture(t, &s, &seed);
        if (etch_triangle_is_parallel(v))
            continue;
        etch_triangle_perspective(&canvas.surface, v, &texture, &etch_perspective_exact);
        hash = test_canvas_hash(&canvas);
        test_canvas_wipe(&canvas);
        etch_triangle_staged(&canvas.surface, plain, &staged, &planes);
        if (!CHECK_EQ(test_canvas_hash(&canvas), hash))
            test_sample_note(&s, 0, i);
    }
}

/* One texel a pixel is a copy, wherever it begins. */
static void textures_one_to_one_are_copies(void)
{
    static const struct etch_pipeline staged = {textured, replace, etch_kernel_staged};
    const struct etch_rect window = {0, 0, 40, 30};
    int32_t x, y, i;

    for (i = 0; i < 9; i++) {
        const int32_t u = (i * 7 - 20) * 65536, v = (i * 5 - 11) * 65536, size = 50;
        const struct etch_texture_vertex t[3] = {
            {{0, 0, 0, 0, 0, 0, 0}, u, v, 1},
            {{2 * size * 256, 0, 0, 0, 0, 0, 0}, u + 2 * size * 65536, v, 1},
            {{0, 2 * size * 256, 0, 0, 0, 0, 0}, u, v + 2 * size * 65536, 1}};
        const struct etch_vertex *const plain[3] = {&t[0].at, &t[1].at, &t[2].at};

        test_canvas_open(&canvas, window);
        etch_triangle_staged(&canvas.surface, plain, &staged, &planes);
        for (y = 0; y < 30; y++)
            for (x = 0; x < 40; x++)
                CHECK_EQ(test_canvas_at(&canvas, x, y),
                         texels[((y + v / 65536) & 3) * 8 + ((x + u / 65536) & 7)]);
    }
}

/* ---- clips and strips ------------------------------------------------------------------------------ */

/* A pipeline with everything that reads planes; each pixel of a narrow clip is that of the whole. */
static void clipped_is_masked(void)
{
    static etch_varying *const all[] = {etch_varying_color_perspective, etch_varying_depth,
                                        etch_varying_texture_perspective, NULL};
    static const struct etch_stage stages[] = {{etch_source_depth, NULL},
                                               {etch_stage_depth_lequal, NULL},
                                               {etch_stage_depth_write, NULL},
                                               {etch_source_color_perspective, NULL},
                                               {etch_source_texture_perspective, NULL},
                                               {etch_stage_texture_modulate, &sampler},
                                               {etch_stage_read, NULL},
                                               {etch_stage_blend_alpha, NULL},
                                               {etch_stage_write, NULL},
                                               END};
    static const struct etch_pipeline pipeline = {all, stages, etch_kernel_staged};
    static uint16_t whole[2][48 * 64];
    uint32_t seed = 66;
    int32_t i, x, y;

    for (i = 0; i < TEST_COUNT(1000) && !test_failed(); i++) {
        struct test_sample s;
        struct etch_texture_vertex t[3];
        const struct etch_vertex *const v[3] = {&t[0].at, &t[1].at, &t[2].at};
        struct etch_rect window, clip;
        int32_t n = 0, wrong = 0;

        test_sample_make(&s, &canvas, i, &seed);
        random_alpha(&s, &seed);
        give_texture(t, &s, &seed);
        for (x = 0; x < 3; x++)
            t[x].at = s.vertex[x];
        etch_triangle_staged(&canvas.surface, v, &pipeline, &planes);
        window = canvas.surface.window;
        for (y = window.y0; y < window.y1; y++)
            for (x = window.x0; x < window.x1; x++, n++) {
                const size_t at = etch_surface_index(&canvas.surface, (int16_t)x, (int16_t)y);

                whole[0][n] = canvas.surface.pixels[at];
                whole[1][n] = canvas.surface.depth[at];
            }
        clip.x0 = (int16_t)test_range(&seed, window.x0, window.x1 - 1);
        clip.y0 = (int16_t)test_range(&seed, window.y0, window.y1 - 1);
        clip.x1 = (int16_t)test_range(&seed, clip.x0, window.x1);
        clip.y1 = (int16_t)test_range(&seed, clip.y0, window.y1);
        test_canvas_clip(&canvas, clip);
        etch_triangle_staged(&canvas.surface, v, &pipeline, &planes);
        CHECK_ONCE(&canvas);
        for (n = 0, y = window.y0; y < window.y1; y++)
            for (x = window.x0; x < window.x1; x++, n++) {
                const size_t at = etch_surface_index(&canvas.surface, (int16_t)x, (int16_t)y);

                if (x >= clip.x0 && x < clip.x1 && y >= clip.y0 && y < clip.y1)
                    wrong += whole[0][n] != canvas.surface.pixels[at] ||
                             whole[1][n] != canvas.surface.depth[at];
            }
        if (!CHECK_EQ(wrong, 0))
            test_sample_note(&s, 0, 0);
    }
}

void suite_staged(void)
{
    RUN(staged_is_fused);
    RUN(textures_in_perspective_are_the_exact_kernel);
    RUN(textures_one_to_one_are_copies);
    RUN(clipped_is_masked);
}
