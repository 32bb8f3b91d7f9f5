/* size/flat_small.c: only flat triangles, by the small names. */
#include "size.h"

#include "../../../core/draw/triangle_small.h"

volatile int16_t size_corner[6];

int main(void)
{
    static const struct etch_surface s = SIZE_SURFACE(NULL);

    etch_triangle_fill_small(&s, size_corner[0], size_corner[1], size_corner[2], size_corner[3],
                             size_corner[4], size_corner[5], 0xFFFF);
    return 0;
}
