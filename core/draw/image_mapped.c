/* draw/image_mapped.c: the nearest texels of places that a map shows. Called by applications and by
 * scaling. See image.h. */
#include "image.h"

/* Texels from one place to the next, with 32 fraction bits of the column; modulo. */
static uint64_t place_of(int64_t u, int64_t v, uint32_t stride)
{
    const uint32_t rows = etch_wrap_mul((uint32_t)(v >> 32), stride);

    return (uint64_t)etch_wrap_add(rows, (uint32_t)(u >> 32)) << 32 | (uint32_t)u;
}

void etch_image_draw_mapped(const struct etch_surface *s, const struct etch_image_style *style,
                            const struct etch_map *map)
{
    const uint16_t stride = style->image->stride;
    const struct etch_rect area = etch_rect_intersect(s->clip, map->bounds);
    struct etch_map m = *map;
    struct etch_image_line line = {
        .image = style->image,
        .step_q32 = place_of(m.ux, m.vx, stride),
        .down_step = (uint32_t)m.vx,
        .opacity = style->opacity,
    };

    m.from = etch_rect_intersect(m.from, etch_image_whole(style->image));
    if (etch_rect_is_empty(m.from) || etch_rect_is_empty(area))
        return;
    for (int16_t y = area.y0; y < area.y1; y++) {
        int16_t x0 = area.x0, x1 = area.x1;

        etch_map_interval(&m, y, &x0, &x1);
        if (x0 < x1) {
            const int64_t v = m.v + m.vy * y + m.vx * x0;

            line.place_q32 = place_of(m.u + m.uy * y + m.ux * x0, v, stride);
            line.down = (uint32_t)v;
            style->row(s->pixels + etch_surface_index(s, x0, y), (uint16_t)(x1 - x0), &line);
        }
    }
}
