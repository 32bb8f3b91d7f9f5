/* draw/image_draw.c: images and their parts as they are. Called by applications. See image.h. */
#include "image_parts.h"

void etch_image_draw_part(const struct etch_surface *s, const struct etch_image_style *style,
                          struct etch_rect part, int16_t x, int16_t y)
{
    const struct etch_image *const image = style->image;
    const struct etch_rect in = etch_rect_intersect(part, etch_image_whole(image));
    const struct etch_image_area area = {
        .x = (int32_t)x + in.x0 - part.x0,
        .y = (int32_t)y + in.y0 - part.y0,
        .w = (int32_t)in.x1 - in.x0,
        .h = (int32_t)in.y1 - in.y0,
        .place = etch_mul_u16((uint16_t)in.y0, image->stride) + (uint16_t)in.x0,
        .dx = 1,
        .dy = image->stride,
    };

    if (!etch_rect_is_empty(in))
        etch_image_area_draw(s, style, &area);
}

void etch_image_draw(const struct etch_surface *s, const struct etch_image_style *style, int16_t x,
                     int16_t y)
{
    etch_image_draw_part(s, style, etch_image_whole(style->image), x, y);
}
