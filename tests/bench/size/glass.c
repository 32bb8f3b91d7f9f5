/* size/glass.c: only triangles of stages: fog, a depth test without writing, blended by alpha. */
#include "size.h"

#include "../../../core/draw/staged.h"
#include "../../../core/fragment/blend.h"
#include "../../../core/fragment/fog.h"
#include "../../../core/fragment/test.h"
#include "../../../core/fragment/write.h"

struct etch_vertex size_vertex[3];
struct etch_fog_linear size_fog;
struct etch_staged_planes size_planes;

int main(void)
{
    static const struct etch_surface s = SIZE_SURFACE(size_depth);
    static const struct etch_vertex *const v[3] = {&size_vertex[0], &size_vertex[1],
                                                   &size_vertex[2]};
    static etch_varying *const varyings[] = {etch_varying_depth, etch_varying_color,
                                             etch_varying_alpha, NULL};
    static const struct etch_stage stages[] = {{etch_source_depth, NULL},
                                               {etch_stage_depth_less, NULL},
                                               {etch_source_color, NULL},
                                               {etch_source_alpha, NULL},
                                               {etch_stage_fog_linear, &size_fog},
                                               {etch_stage_read, NULL},
                                               {etch_stage_blend_alpha, NULL},
                                               {etch_stage_write, NULL},
                                               {NULL, NULL}};
    static const struct etch_pipeline glass = {varyings, stages, etch_kernel_staged};

    (void)etch_fog_linear_init(&size_fog, 1000, 60000, 90, 100, 110);
    etch_triangle_staged(&s, v, &glass, &size_planes);
    return 0;
}
