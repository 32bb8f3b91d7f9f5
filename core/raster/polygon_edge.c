/* raster/polygon_edge.c: edges of polygons, set up and moved. Called by polygon.c, polygon_walk.c
 * and edge_flags.c. See polygon_edge.h. */
#include "polygon_edge.h"

/* The first row whose centre is at or below y. */
static int32_t row_of(int32_t y_q8)
{
    return (y_q8 + 127) >> 8;
}

/* floor(dx / dy), with the remainder in *rest. */
static int32_t divide(int32_t dx, int32_t dy, int32_t *rest)
{
    const int32_t quotient = dx >= 0 ? dx / dy : -((dy - 1 - dx) / dy);

    *rest = dx - quotient * dy;
    return quotient;
}

bool etch_polygon_edge_setup(struct etch_polygon_edge *g, struct etch_point_q8 a,
                             struct etch_point_q8 b)
{
    const bool up = b.y < a.y;
    const struct etch_point_q8 p = up ? b : a, q = up ? a : b;
    const int32_t y0 = row_of(p.y), y1 = row_of(q.y), least = p.x < q.x ? p.x : q.x;

    if (y0 == y1 || y0 >= INT16_MAX)
        return false;
    g->dy = q.y - p.y;
    g->quotient = divide(q.x - p.x, g->dy, &g->remainder);
    g->y = g->y0 = (int16_t)y0;
    g->y1 = (int16_t)(y1 < INT16_MAX ? y1 : INT16_MAX);
    g->left = (int16_t)(least >> 8 < INT16_MAX ? least >> 8 : INT16_MAX);
    g->winding = up ? -1 : 1;

    /* The edge crosses a row, so k < dy: |k quotient| <= |dx|. M / dy is the whole pixels of x_q8
     * and (f dy + k remainder) / (256 dy) < 2. */
    const int32_t k = (128 - p.y) & 255, x_q8 = p.x - 128 + k * g->quotient, f = x_q8 & 255;
    const uint64_t sum = (uint64_t)f * (uint32_t)g->dy + (uint64_t)k * (uint32_t)g->remainder;

    g->x = x_q8 >> 8;
    g->e = -(int32_t)((sum + 255) >> 8);
    for (; g->e < 0; g->x++)
        g->e += g->dy;
    return true;
}

/* |k| <= 2^16 and remainder < 2^24: the sums stay below 2^41. */
void etch_polygon_edge_move(struct etch_polygon_edge *g, int16_t y)
{
    const int32_t k = (int32_t)y - g->y;
    const uint32_t away = (uint32_t)(k < 0 ? -k : k);
    struct etch_quotient r;

    if (k == 0)
        return;
    r = etch_divide_u64((uint64_t)away * (uint32_t)g->remainder, (uint64_t)g->dy);
    g->y = y;
    g->x += k * g->quotient;
    if (k > 0) {
        g->x += (int32_t)r.quotient;
        g->e -= (int32_t)r.remainder;
    } else {
        g->x -= (int32_t)r.quotient;
        g->e += (int32_t)r.remainder;
    }
    if (g->e < 0)
        g->e += g->dy, g->x++;
    else if (g->e >= g->dy)
        g->e -= g->dy, g->x--;
}
