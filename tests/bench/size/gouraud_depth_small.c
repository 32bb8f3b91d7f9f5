/* size/gouraud_depth_small.c: only Gouraud triangles with a depth test, by the small names. */
#include "size.h"

#include "../../../core/draw/triangle_small.h"
#include "../../../core/fragment/gouraud_small.h"

struct etch_vertex size_vertex[3];

int main(void)
{
    static const struct etch_surface s = SIZE_SURFACE(size_depth);
    static const struct etch_vertex *const v[3] = {&size_vertex[0], &size_vertex[1],
                                                   &size_vertex[2]};

    etch_triangle_gouraud_depth_small(&s, v, etch_kernel_gouraud_less_small);
    return 0;
}
