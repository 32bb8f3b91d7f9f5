/* raster/line_plane.c: the plane of a varying along a line. Called by the painters of lines and by
 * applications. See line_runs.h. */
#include "line_runs.h"

/* (v1 - v0) / d to the nearest unit, modulo 2^32; 1 <= d <= 65535. */
static uint32_t slope(uint32_t v0, uint32_t v1, uint32_t d)
{
    const bool falls = v1 < v0;
    const uint32_t rise = falls ? v0 - v1 : v1 - v0;
    const uint32_t step = rise / d + (rise % d > (d - 1) / 2 ? 1 : 0);

    return falls ? etch_wrap_sub(0, step) : step;
}

void etch_line_plane(struct etch_plane *plane, int16_t x0, int16_t y0, int16_t x1, int16_t y1,
                     uint32_t v0, uint32_t v1)
{
    const int32_t dx = (int32_t)x1 - x0, dy = (int32_t)y1 - y0;
    const bool steep = (dy < 0 ? -dy : dy) > (dx < 0 ? -dx : dx);
    const int32_t du = steep ? dy : dx;
    const int32_t from = steep ? (du < 0 ? y1 : y0) : (du < 0 ? x1 : x0);
    uint32_t step;

    plane->origin = (v0 >> 1) + (v1 >> 1) + (v0 & v1 & 1); /* one pixel */
    plane->dx = 0;
    plane->dy = 0;
    if (du == 0)
        return;
    step = du < 0 ? slope(v1, v0, (uint32_t)-du) : slope(v0, v1, (uint32_t)du);
    plane->origin = etch_wrap_sub(du < 0 ? v1 : v0, etch_wrap_mul(step, (uint32_t)from));
    plane->dx = steep ? 0 : step;
    plane->dy = steep ? step : 0;
}
