/* size/traces.c: only lines of stages, blended by alpha. */
#include "size.h"

#include "../../../core/draw/line_staged.h"
#include "../../../core/fragment/blend.h"
#include "../../../core/fragment/write.h"

struct etch_vertex size_vertex[2];
struct etch_staged_planes size_planes;

int main(void)
{
    static const struct etch_surface s = SIZE_SURFACE(NULL);
    static const struct etch_vertex *const v[2] = {&size_vertex[0], &size_vertex[1]};
    static etch_line_varying *const varyings[] = {etch_line_varying_color, etch_line_varying_alpha,
                                                  NULL};
    static const struct etch_stage stages[] = {
        {etch_source_color, NULL},      {etch_source_alpha, NULL}, {etch_stage_read, NULL},
        {etch_stage_blend_alpha, NULL}, {etch_stage_write, NULL},  {NULL, NULL}};
    static const struct etch_line_pipeline traces = {varyings, stages, etch_kernel_staged};

    etch_line_staged(&s, v, &traces, &size_planes);
    return 0;
}
