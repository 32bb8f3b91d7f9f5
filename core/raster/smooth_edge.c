/* raster/smooth_edge.c: where an edge crosses the lines of a row. Called by smooth_walk.c and
 * smooth_line.c. See smooth_walk.h.
 *
 * On line k an edge lies at x = a.x + floor(dx t / dy) with t = 16 k + 8 - a.y, 0 <= t < dy: the
 * product is below 2^49. From line to line it steps by 16 dx / dy, |16 dx| <= 2^28. */
#include "smooth_walk.h"

void etch_smooth_edge_place(struct etch_smooth_edge *g, int32_t line)
{
    const int32_t t = 16 * line + 8 - g->a.y;
    const int64_t n = etch_mul_s32(g->dx, t);
    const struct etch_quotient d = etch_divide_u64((uint64_t)(n < 0 ? -n : n), (uint64_t)g->dy);
    const int32_t q = (int32_t)d.quotient, r = (int32_t)d.remainder;

    g->x = n < 0 ? g->a.x - q - (r != 0) : g->a.x + q;
    g->e = n < 0 && r != 0 ? g->dy - r : r;
}

void etch_smooth_edge_step(struct etch_smooth_edge *g)
{
    const uint32_t d = 16 * (uint32_t)(g->dx < 0 ? -g->dx : g->dx), whole = d / (uint32_t)g->dy;
    const int32_t rest = (int32_t)(d - whole * (uint32_t)g->dy);
    const bool up = g->dx < 0 && rest != 0;

    g->x += (g->dx < 0 ? -(int32_t)whole : (int32_t)whole) - up;
    g->e += up ? g->dy - rest : rest;
    if (g->e >= g->dy)
        g->e -= g->dy, g->x++;
}
