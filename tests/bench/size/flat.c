/* size/flat.c: only flat triangles. */
#include "size.h"

#include "../../../core/draw/shapes.h"

volatile int16_t size_corner[6];

int main(void)
{
    static const struct etch_surface s = SIZE_SURFACE(NULL);

    etch_triangle_fill(&s, size_corner[0], size_corner[1], size_corner[2], size_corner[3],
                       size_corner[4], size_corner[5], 0xFFFF);
    return 0;
}
