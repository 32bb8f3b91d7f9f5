/* draw/image_scaled.c: images over rectangles. Called by applications and by nine-patches. See
 * image.h. */
#include "image.h"

void etch_image_draw_scaled(const struct etch_surface *s, const struct etch_image_style *style,
                            struct etch_rect part, int16_t x, int16_t y, int16_t w, int16_t h)
{
    struct etch_map map;

    etch_map_scale(&map, etch_rect_intersect(part, etch_image_whole(style->image)), x, y, w, h);
    etch_image_draw_mapped(s, style, &map);
}
