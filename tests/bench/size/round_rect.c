/* size/round_rect.c: rounded rectangles, filled and drawn. */
#include "size.h"

#include "../../../core/draw/round.h"

volatile int16_t size_at[6];

int main(void)
{
    static const struct etch_surface s = SIZE_SURFACE(NULL);

    etch_round_rect_fill(&s, size_at[0], size_at[1], size_at[2], size_at[3], size_at[4], 0xFFFF);
    etch_round_rect_draw(&s, size_at[0], size_at[1], size_at[2], size_at[3], size_at[4], 0xFFFF);
    return 0;
}
