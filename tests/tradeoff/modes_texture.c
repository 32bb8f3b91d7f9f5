/* tradeoff/modes_texture.c: perspective. See tradeoff.h. */
#include "../../core/draw/staged.h"
#include "../../core/draw/texture.h"
#include "../../core/fragment/sampler.h"
#include "../../core/fragment/source_blocks.h"
#include "../../core/fragment/texture.h"
#include "../../core/fragment/write.h"
#include "tradeoff.h"

static struct etch_texture texture(void)
{
    struct etch_texture t = {NULL, 0, 0};

    (void)etch_texture_init(&t, tradeoff_texels, TRADEOFF_TEXTURE, TRADEOFF_TEXTURE);
    return t;
}

void draw_affine(const struct etch_surface *s, const struct tradeoff_scene *scene)
{
    const struct etch_texture t = texture();

    for (uint16_t i = 0; i < scene->count; i++) {
        const struct etch_texture_vertex *const v[3] = TRADEOFF_TRIANGLE(scene, i);

        etch_triangle_texture(s, v, &t, etch_kernel_texture);
    }
}

#define PERSPECTIVE(name, kernels)                                                                 \
    void draw_##name(const struct etch_surface *s, const struct tradeoff_scene *scene)             \
    {                                                                                              \
        const struct etch_texture t = texture();                                                   \
                                                                                                   \
        for (uint16_t i = 0; i < scene->count; i++) {                                              \
            const struct etch_texture_vertex *const v[3] = TRADEOFF_TRIANGLE(scene, i);            \
                                                                                                   \
            etch_triangle_perspective(s, v, &t, &kernels);                                         \
        }                                                                                          \
    }

PERSPECTIVE(divide_16, etch_perspective)
PERSPECTIVE(divide_1, etch_perspective_exact)

/* A divide every 8 pixels is made of stages. */
void draw_divide_8(const struct etch_surface *s, const struct tradeoff_scene *scene)
{
    static etch_varying *const varyings[] = {etch_varying_texture_perspective, NULL};
    const struct etch_image image = {.colors = etch_texels_rgb565,
                                     .texels = tradeoff_texels,
                                     .width = TRADEOFF_TEXTURE,
                                     .height = TRADEOFF_TEXTURE,
                                     .stride = TRADEOFF_TEXTURE};
    struct etch_sampler sampler;
    const struct etch_stage stages[] = {{etch_source_texture_blocks8, NULL},
                                        {etch_stage_texture_replace, &sampler},
                                        {etch_stage_write, NULL},
                                        {NULL, NULL}};
    const struct etch_pipeline pipeline = {varyings, stages, etch_kernel_staged};
    struct etch_staged_planes planes;

    (void)etch_sampler_init(&sampler, &image, etch_filter_nearest_power, etch_texels_repeat);
    for (uint16_t i = 0; i < scene->count; i++) {
        const struct etch_texture_vertex *const w[3] = TRADEOFF_TRIANGLE(scene, i);
        const struct etch_vertex *const v[3] = {&w[0]->at, &w[1]->at, &w[2]->at};

        etch_triangle_staged(s, v, &pipeline, &planes);
    }
}
