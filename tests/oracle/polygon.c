/* tests/oracle: polygons by crossings. See polygon.h. */
#include "polygon.h"

int32_t oracle_polygon_crossings(const struct oracle_edge *edge, int32_t n, int32_t x, int32_t y,
                                 int32_t *winding)
{
    const int64_t cx = 256 * (int64_t)x + 128, cy = 256 * (int64_t)y + 128;
    int32_t count = 0, i;

    *winding = 0;
    for (i = 0; i < n; i++) {
        const bool down = edge[i].ay < edge[i].by;
        const int64_t x0 = down ? edge[i].ax : edge[i].bx, y0 = down ? edge[i].ay : edge[i].by;
        const int64_t x1 = down ? edge[i].bx : edge[i].ax, y1 = down ? edge[i].by : edge[i].ay;

        if (y0 > cy || y1 <= cy || (x1 - x0) * (cy - y0) > (cx - x0) * (y1 - y0))
            continue;
        count++;
        *winding += down ? 1 : -1;
    }
    return count;
}
