/* draw/image_area.c: a rectangle of texels, pixel for pixel. Called by blits and turns. See
 * image_parts.h. */
#include "image_parts.h"

static int32_t greater(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

static int32_t less(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

void etch_image_area_draw(const struct etch_surface *s, const struct etch_image_style *style,
                          const struct etch_image_area *a)
{
    const int32_t x0 = greater(a->x, s->clip.x0), x1 = less(a->x + a->w, s->clip.x1);
    const int32_t y0 = greater(a->y, s->clip.y0), y1 = less(a->y + a->h, s->clip.y1);
    struct etch_image_line line = {
        .image = style->image,
        .step_q32 = (uint64_t)a->dx << 32,
        .opacity = style->opacity,
    };
    uint32_t place = etch_wrap_add(a->place, etch_wrap_mul((uint32_t)(x0 - a->x), a->dx));

    if (x0 >= x1)
        return;
    place = etch_wrap_add(place, etch_wrap_mul((uint32_t)(y0 - a->y), a->dy));
    for (int32_t y = y0; y < y1; y++) {
        line.place_q32 = (uint64_t)place << 32;
        style->row(s->pixels + etch_surface_index(s, (int16_t)x0, (int16_t)y), (uint16_t)(x1 - x0),
                   &line);
        place = etch_wrap_add(place, a->dy);
    }
}
