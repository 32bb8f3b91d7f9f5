/* size/pattern.c: rectangles in a pattern, a tile and a stipple; dotted lines. */
#include "size.h"

#include "../../../core/draw/line_stipple.h"
#include "../../../core/fragment/flat.h"
#include "../../../core/fragment/pattern.h"
#include "../../../core/raster/rect.h"

volatile int16_t size_at[6];

int main(void)
{
    static const struct etch_surface s = SIZE_SURFACE(NULL);
    static const uint8_t row[8] = {0x80, 0x40, 0x20, 0x10, 8, 4, 2, 1};
    static const uint16_t texels[4] = {1, 2, 3, 4};
    const struct etch_flat_paint flat = {{etch_kernel_flat}, 0xFFFF};
    const struct etch_stipple_paint stipple = {{etch_kernel_stipple}, row, &flat.paint};
    const struct etch_rect r = etch_rect_from_size(size_at[0], size_at[1], size_at[2], size_at[3]);
    struct etch_pattern pattern;
    struct etch_tile tile;
    struct etch_brush_paint paint = {{etch_kernel_brush}, &pattern.brush, 255};

    etch_pattern_init(&pattern, row, 0, 0xFFFF);
    if (etch_tile_init(&tile, texels, 2, 2, 2, 0, 0))
        return 1;
    etch_rect_runs(&s, r, &paint.paint);
    paint.brush = &tile.brush;
    etch_rect_runs(&s, r, &paint.paint);
    etch_rect_runs(&s, r, &stipple.paint);
    etch_line_stipple_draw(&s, size_at[0], size_at[1], size_at[2], size_at[3], 0xFF00, 0xFFFF);
    return 0;
}
