/* size/texture_depth_small.c: only textured triangles in perspective with a depth test, by
 * the small names. */
#include "size.h"

#include "../../../core/draw/texture_small.h"
#include "../../../core/fragment/texture_small.h"

struct etch_texture_vertex size_vertex[3];
struct etch_texture size_texture;

int main(void)
{
    static const struct etch_surface s = SIZE_SURFACE(size_depth);
    static const struct etch_texture_vertex *const v[3] = {&size_vertex[0], &size_vertex[1],
                                                           &size_vertex[2]};

    etch_triangle_perspective_depth_small(&s, v, &size_texture, etch_kernel_perspective_less_small);
    return 0;
}
