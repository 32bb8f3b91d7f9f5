/* size/text.c: one font of ASCII and the basic shapes: lines, rectangles, discs, triangles. */
#include "size.h"

#include "../../../core/draw/text.h"
#include "../../../core/draw/triangle_small.h"
#include "../../../core/fonts/fonts.h"
#include "../../../core/fragment/flat.h"
#include "../../../core/fragment/flat_small.h"
#include "../../../core/raster/circle.h"
#include "../../../core/raster/line_small.h"
#include "../../../core/raster/rect.h"

volatile int16_t size_at[6];
const char *volatile size_text;

int main(void)
{
    static const struct etch_surface s = SIZE_SURFACE(NULL);
    static const struct etch_flat_paint flat = {{etch_kernel_flat_small}, 0xFFFF};
    static const struct etch_text_style style = {&etch_font_fixed_5x8_ascii, etch_glyph_solid,
                                                 0xFFFF, 0};

    etch_line_draw_small(&s, size_at[0], size_at[1], size_at[2], size_at[3], 0xFFFF);
    etch_rect_runs(&s, etch_rect_from_size(size_at[0], size_at[1], size_at[2], size_at[3]),
                   &flat.paint);
    etch_circle_runs(&s, size_at[0], size_at[1], size_at[2], &flat.paint);
    etch_triangle_fill_small(&s, size_at[0], size_at[1], size_at[2], size_at[3], size_at[4],
                             size_at[5], 0xFFFF);
    etch_text_draw(&s, &style, size_at[0], size_at[1], size_text, NULL);
    return 0;
}
