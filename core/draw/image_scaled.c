/* draw/image_scaled.c: images over rectangles. Called by applications and by nine-patches. See
 * image.h. */
#include "image.h"

/* Of the map of a rectangle every pixel inside the bounds shows a texel (map_scale.c), and a row or
 * a column of the frame is one of the image. What is kept here is not on the stack under the map's
 * divisions. */
static ETCH_APART void draw_rows(const struct etch_surface *s, const struct etch_image_style *style,
                                 const struct etch_map *map)
{
    const struct etch_rect area = etch_rect_intersect(s->clip, map->bounds);
    const uint64_t u = (uint64_t)(map->u + map->ux * area.x0);
    struct etch_image_line line = {
        .image = style->image, .step_q32 = (uint64_t)map->ux, .opacity = style->opacity};

    if (etch_rect_is_empty(area))
        return;
    for (int16_t y = area.y0; y < area.y1; y++) {
        const uint32_t row = (uint32_t)((map->v + map->vy * y) >> 32);

        line.place_q32 = u + ((uint64_t)(row * style->image->stride) << 32);
        style->row(s->pixels + etch_surface_index(s, area.x0, y), (uint16_t)(area.x1 - area.x0),
                   &line);
    }
}

void etch_image_draw_scaled(const struct etch_surface *s, const struct etch_image_style *style,
                            struct etch_rect part, int16_t x, int16_t y, int16_t w, int16_t h)
{
    struct etch_map map;

    etch_map_scale(&map, etch_rect_intersect(part, etch_image_whole(style->image)), x, y, w, h);
    draw_rows(s, style, &map);
}
