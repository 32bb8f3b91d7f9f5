/* size/gouraud_small.c: only Gouraud triangles, by the small names. */
#include "size.h"

#include "../../../core/draw/triangle_small.h"
#include "../../../core/fragment/gouraud_small.h"

struct etch_vertex size_vertex[3];

int main(void)
{
    static const struct etch_surface s = SIZE_SURFACE(NULL);
    static const struct etch_vertex *const v[3] = {&size_vertex[0], &size_vertex[1],
                                                   &size_vertex[2]};

    etch_triangle_gouraud_small(&s, v, etch_kernel_gouraud_small);
    return 0;
}
