/* raster/edge_flags.c: edges to bits. Called by applications. See edge_flags.h. */
#include "edge_flags.h"
#include "polygon_edge.h"

enum etch_status etch_edge_flags_init(struct etch_edge_flags *f, struct etch_rect rect,
                                      uint8_t *bits, size_t room)
{
    uint32_t n;

    if (etch_rect_is_empty(rect))
        return ETCH_EINVAL;
    f->stride = (uint16_t)(((int32_t)rect.x1 - rect.x0 + 7) / 8);
    n = (uint32_t)f->stride * (uint32_t)((int32_t)rect.y1 - rect.y0);
    if (room < n)
        return ETCH_ENOMEM;
    f->bits = bits;
    f->rect = rect;
    while (n != 0)
        bits[--n] = 0;
    return ETCH_OK;
}

/* What is left of the rectangle inverts its first column, what is right of it nothing. */
void etch_edge_flags_add_edge(struct etch_edge_flags *f, struct etch_point_q8 a,
                              struct etch_point_q8 b)
{
    const struct etch_rect *const r = &f->rect;
    struct etch_polygon_edge g;
    int16_t y, y1;
    uint8_t *row;

    if (!etch_polygon_edge_setup(&g, a, b))
        return;
    y = g.y0 > r->y0 ? g.y0 : r->y0;
    y1 = g.y1 < r->y1 ? g.y1 : r->y1;
    if (y >= y1)
        return;
    etch_polygon_edge_move(&g, y);
    row = f->bits + (size_t)((int32_t)y - r->y0) * f->stride;
    for (; y < y1; y++, row += f->stride) {
        const int32_t x = g.x > r->x0 ? g.x - r->x0 : 0;

        if (g.x < r->x1)
            row[x >> 3] = (uint8_t)(row[x >> 3] ^ 0x80 >> (x & 7));
        etch_polygon_edge_step(&g);
    }
}

void etch_edge_flags_add(struct etch_edge_flags *f, const struct etch_point_q8 *v, uint16_t n)
{
    for (uint16_t i = 0; i < n; i++)
        etch_edge_flags_add_edge(f, v[i], v[i + 1 == n ? 0 : i + 1]);
}
