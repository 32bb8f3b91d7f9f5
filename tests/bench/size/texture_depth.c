/* size/texture_depth.c: only textured triangles in perspective with a depth test. */
#include "size.h"

#include "../../../core/draw/texture.h"

struct etch_texture_vertex size_vertex[3];
struct etch_texture size_texture;

int main(void)
{
    static const struct etch_surface s = SIZE_SURFACE(size_depth);
    static const struct etch_texture_vertex *const v[3] = {&size_vertex[0], &size_vertex[1],
                                                           &size_vertex[2]};

    etch_triangle_perspective_depth(&s, v, &size_texture, &etch_perspective_less);
    return 0;
}
