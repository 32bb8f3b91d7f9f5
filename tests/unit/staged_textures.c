/* tests/unit: textures by stages as by their fused kernels, copies one to one, and a pipeline of
 * all that reads planes: clips change nothing. */
#include "core/draw/staged.h"
#include "core/draw/texture.h"
#include "core/fragment/blend.h"
#include "core/fragment/sampler.h"
#include "core/fragment/test.h"
#include "core/fragment/texture.h"
#include "core/fragment/write.h"
#include "tests/harness/canvas.h"
#include "tests/harness/sample.h"

void suite_staged_textures(void);

static struct test_canvas canvas;
static struct etch_staged_planes planes;

#define END                                                                                        \
    {                                                                                              \
        NULL, NULL                                                                                 \
    }

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
        out[k].at.a = (uint8_t)test_range(seed, 0, 255);
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

/* ---- clips and strips
 * ------------------------------------------------------------------------------ */

/* A pipeline with everything that reads planes. */
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

/* Colours and depths of the window. */
struct planes {
    uint16_t color[48 * 64], depth[48 * 64];
};

static void take_planes(struct planes *to)
{
    const struct etch_rect window = canvas.surface.window;
    int32_t n = 0;

    for (int32_t y = window.y0; y < window.y1; y++)
        for (int32_t x = window.x0; x < window.x1; x++, n++) {
            const size_t at = etch_surface_index(&canvas.surface, (int16_t)x, (int16_t)y);

            to->color[n] = canvas.surface.pixels[at];
            to->depth[n] = canvas.surface.depth[at];
        }
}

/* How many pixels of the clip differ. */
static int32_t differ(const struct planes *a, const struct planes *b)
{
    const struct etch_rect window = canvas.surface.window, clip = canvas.surface.clip;
    int32_t n = 0, wrong = 0;

    for (int32_t y = window.y0; y < window.y1; y++)
        for (int32_t x = window.x0; x < window.x1; x++, n++)
            if (x >= clip.x0 && x < clip.x1 && y >= clip.y0 && y < clip.y1)
                wrong += a->color[n] != b->color[n] || a->depth[n] != b->depth[n];
    return wrong;
}

static struct etch_rect random_part(struct etch_rect window, uint32_t *seed)
{
    struct etch_rect clip;

    clip.x0 = (int16_t)test_range(seed, window.x0, window.x1 - 1);
    clip.y0 = (int16_t)test_range(seed, window.y0, window.y1 - 1);
    clip.x1 = (int16_t)test_range(seed, clip.x0, window.x1);
    clip.y1 = (int16_t)test_range(seed, clip.y0, window.y1);
    return clip;
}

/* Each pixel of a narrow clip is that of the whole. */
static void clipped_is_masked(void)
{
    static struct planes whole, part;
    uint32_t seed = 66;

    for (int32_t i = 0; i < TEST_COUNT(1000) && !test_failed(); i++) {
        struct test_sample s;
        struct etch_texture_vertex t[3];
        const struct etch_vertex *const v[3] = {&t[0].at, &t[1].at, &t[2].at};

        test_sample_make(&s, &canvas, i, &seed);
        give_texture(t, &s, &seed);
        etch_triangle_staged(&canvas.surface, v, &pipeline, &planes);
        take_planes(&whole);
        test_canvas_clip(&canvas, random_part(canvas.surface.window, &seed));
        etch_triangle_staged(&canvas.surface, v, &pipeline, &planes);
        CHECK_ONCE(&canvas);
        take_planes(&part);
        if (!CHECK_EQ(differ(&whole, &part), 0))
            test_sample_note(&s, 0, 0);
    }
}

void suite_staged_textures(void)
{
    RUN(textures_in_perspective_are_the_exact_kernel);
    RUN(textures_one_to_one_are_copies);
    RUN(clipped_is_masked);
}
