/* size/bilinear.c: an RGB565 image stretched with the mean of the four nearest texels. */
#include "size.h"

#include "../../../core/fragment/sampler.h"
#include "../../../core/fragment/source_map.h"
#include "../../../core/fragment/write.h"
#include "../../../core/raster/map_runs.h"

volatile int16_t size_at[4];
static uint16_t texels[64 * 64];

int main(void)
{
    static const struct etch_surface s = SIZE_SURFACE(NULL);
    static const struct etch_sampler sampler = {.image = {.colors = etch_texels_rgb565,
                                                          .texels = texels,
                                                          .width = 64,
                                                          .height = 64,
                                                          .stride = 64},
                                                .filter = etch_filter_linear_clamp};
    const struct etch_rect all = {0, 0, 64, 64};
    struct etch_map map;
    const struct etch_stage stages[] = {{etch_source_map, &map},
                                        {etch_stage_texture_replace, &sampler},
                                        {etch_stage_write, NULL},
                                        {NULL, NULL}};
    const struct etch_staged_paint paint = {{etch_kernel_staged}, stages};

    etch_map_scale(&map, all, size_at[0], size_at[1], size_at[2], size_at[3]);
    etch_map_runs(&s, &map, &paint.paint);
    return 0;
}
