/* tests/unit: staged pixel work is that of the fused kernels bit for bit where both exist
 * (textures: staged_textures.c). */
#include "core/draw/shapes.h"
#include "core/draw/blend.h"
#include "core/draw/staged.h"
#include "core/draw/triangle.h"
#include "core/fragment/blend.h"
#include "core/fragment/blend_fused.h"
#include "core/fragment/flat.h"
#include "core/fragment/gouraud.h"
#include "core/fragment/test.h"
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

/* ---- the same as fused ------------------------------------------------------------------------
 */

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

void suite_staged(void)
{
    RUN(staged_is_fused);
}
