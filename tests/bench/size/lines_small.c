/* size/lines_small.c: only lines, by the small name. */
#include "size.h"

#include "../../../core/raster/line_small.h"

volatile int16_t size_line[4];

int main(void)
{
    static const struct etch_surface s = SIZE_SURFACE(NULL);

    etch_line_draw_small(&s, size_line[0], size_line[1], size_line[2], size_line[3], 0xFFFF);
    return 0;
}
