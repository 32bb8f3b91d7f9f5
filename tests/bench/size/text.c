/* size/text.c: one font of ASCII and the basic shapes: a cleared frame, lines, rectangles, circles,
 * discs, triangles. */
#include "size.h"

#include "../../../core/draw/shapes_small.h"
#include "../../../core/draw/text_small.h"
#include "../../../core/draw/triangle_small.h"
#include "../../../core/fonts/fonts.h"
#include "../../../core/raster/line_small.h"

volatile int16_t size_at[6];
const char *volatile size_text;

int main(void)
{
    static const struct etch_surface s = SIZE_SURFACE(NULL);
    static const struct etch_text_style style = {&etch_font_fixed_5x8_ascii, etch_glyph_solid_small,
                                                 0xFFFF, 0};

    etch_rect_fill_small(&s, 0, 0, 320, 240, 0x0000);
    etch_line_draw_small(&s, size_at[0], size_at[1], size_at[2], size_at[3], 0xFFFF);
    etch_rect_fill_small(&s, size_at[0], size_at[1], size_at[2], size_at[3], 0xFFFF);
    etch_circle_draw_small(&s, size_at[0], size_at[1], size_at[2], 0xFFFF);
    etch_circle_fill_small(&s, size_at[0], size_at[1], size_at[2], 0xFFFF);
    etch_triangle_fill_small(&s, size_at[0], size_at[1], size_at[2], size_at[3], size_at[4],
                             size_at[5], 0xFFFF);
    etch_text_draw(&s, &style, size_at[0], size_at[1], size_text, NULL);
    return 0;
}
