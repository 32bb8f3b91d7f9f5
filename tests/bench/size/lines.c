/* size/lines.c: only lines. */
#include "size.h"

#include "../../../core/raster/line.h"

volatile int16_t size_line[4];

int main(void)
{
    static const struct etch_surface s = SIZE_SURFACE(NULL);

    etch_line_draw(&s, size_line[0], size_line[1], size_line[2], size_line[3], 0xFFFF);
    return 0;
}
