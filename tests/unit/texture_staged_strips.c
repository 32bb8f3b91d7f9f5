/* tests/unit: textures of any format, filter, wrap, environment and mipmap through whole pipelines:
 * strips and clips change nothing. */
#include "core/draw/staged.h"
#include "core/fragment/blend.h"
#include "core/fragment/mipmap.h"
#include "core/fragment/source_blocks.h"
#include "core/fragment/write.h"
#include "tests/harness/canvas.h"
#include "tests/harness/shapes.h"
#include "tests/unit/texel_parts.h"

void suite_texture_staged_strips(void);

static struct test_canvas canvas;
static struct texels texels;

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

static const struct etch_rect strips_window = {100, 50, 164, 80};

/* A triangle with any source, environment, filter, wrap and format, its levels in *mipmap. */
static void make_scene(struct scene *s, struct etch_mipmap *mipmap, int32_t i, uint32_t *seed)
{
    static etch_stage_function *const sources[] = {
        etch_source_texture, etch_source_texture_perspective, etch_source_texture_blocks8,
        etch_source_texture_blocks16};
    static etch_stage_function *const environments[] = {
        etch_stage_texture_replace, etch_stage_texture_modulate, etch_stage_texture_decal};
    static etch_texel_wrap *const wraps[] = {etch_texels_repeat, etch_texels_clamp,
                                             etch_texels_mirror};
    static uint16_t small[700];
    static uint8_t small_alpha[700];
    struct etch_image image = texels_image(&texels, i % 4);
    struct test_triangle t;

    s->mipmap = mipmap;
    s->source = sources[i / 4 % 4];
    s->environment = environments[i / 16 % 3];
    s->filter = i / 2 % 2 == 0 ? etch_filter_nearest : etch_filter_linear;
    s->wrap = wraps[i / 3 % 3];
    s->perspective = i / 4 % 4 != 0;
    texels_fill(&texels, seed);
    image.width = image.stride = (uint16_t)test_range(seed, 1, 32);
    image.height = (uint16_t)test_range(seed, 1, 32);
    CHECK_EQ(etch_mipmap_build(mipmap, &image, small, small_alpha, 700), ETCH_OK);
    test_triangle_make(&t, (enum test_triangle_kind)(i % TEST_TRIANGLE_KINDS), strips_window, seed);
    for (int k = 0; k < 3; k++) {
        const struct etch_vertex at = {t.x[k],
                                       t.y[k],
                                       UINT32_C(5) << 16,
                                       255,
                                       (uint8_t)test_range(seed, 0, 255),
                                       255,
                                       (uint8_t)test_range(seed, 0, 255)};

        s->v[k].at = at;
        s->v[k].u = test_range(seed, -200, 200) * 65536;
        s->v[k].v = test_range(seed, -200, 200) * 65536;
        s->v[k].w = (uint32_t)test_range(seed, 1, 20);
    }
}

/* Some rows (0), some columns (1), a part of both. */
static struct etch_rect part_of(int k, uint32_t *seed)
{
    const int16_t left = (int16_t)(k == 0 ? 0 : test_range(seed, 0, 54));
    const int16_t above = (int16_t)(k == 1 ? 0 : test_range(seed, 0, 22));
    const struct etch_rect part = {(int16_t)(100 + left), (int16_t)(50 + above),
                                   (int16_t)(k == 0 ? 164 : 110 + left),
                                   (int16_t)(k == 1 ? 80 : 58 + above)};

    return part;
}

static void strips_and_clips_change_nothing(void)
{
    static uint16_t whole[30][64];
    uint32_t seed = 104;

    for (int32_t i = 0; i < TEST_COUNT(600) && !test_failed(); i++) {
        struct etch_mipmap mipmap;
        struct scene s;
        int32_t wrong = 0;

        make_scene(&s, &mipmap, i, &seed);
        test_canvas_open(&canvas, strips_window);
        draw_scene(&s);
        for (int32_t y = 0; y < 30; y++)
            for (int32_t x = 0; x < 64; x++)
                whole[y][x] = test_canvas_at(&canvas, x + 100, y + 50);
        for (int k = 0; k < 3; k++) {
            const struct etch_rect part = part_of(k, &seed);

            test_canvas_open(&canvas, part);
            draw_scene(&s);
            for (int32_t y = part.y0; y < part.y1; y++)
                for (int32_t x = part.x0; x < part.x1; x++)
                    wrong += test_canvas_at(&canvas, x, y) != whole[y - 50][x - 100];
            CHECK_ONCE(&canvas);
        }
        if (!CHECK_EQ(wrong, 0))
            test_note("case", i);
    }
}

void suite_texture_staged_strips(void)
{
    RUN(strips_and_clips_change_nothing);
}
