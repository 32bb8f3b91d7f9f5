/* size/borders.c: the borders of rings and pies. */
#include "size.h"

#include "../../../core/draw/round.h"

volatile int16_t size_at[6];

int main(void)
{
    static const struct etch_surface s = SIZE_SURFACE(NULL);

    etch_ring_draw(&s, size_at[0], size_at[1], size_at[2], size_at[3], 0xFFFF);
    etch_pie_draw(&s, size_at[0], size_at[1], size_at[2], (uint16_t)size_at[4],
                  (uint16_t)size_at[5], 0xFFFF);
    return 0;
}
