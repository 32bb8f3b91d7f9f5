/* raster/outline_round_rect.c: rounded rectangles as contours. Called by applications. See
 * outline.h. */
#include "outline_parts.h"

void etch_outline_round_rect(const struct etch_outline *o, struct etch_point_q8 a,
                             struct etch_point_q8 b, int32_t radius)
{
    const int32_t x0 = a.x < b.x ? a.x : b.x, x1 = a.x < b.x ? b.x : a.x;
    const int32_t y0 = a.y < b.y ? a.y : b.y, y1 = a.y < b.y ? b.y : a.y;
    const int32_t least = (x1 - x0 < y1 - y0 ? x1 - x0 : y1 - y0) / 2;
    const int32_t r = radius < 0 ? 0 : radius < least ? radius : least;
    const uint32_t n = r > 0 ? etch_outline_chords(r) / 4u : 1;
    const struct etch_point_q8 centre[4] = {
        {x1 - r, y1 - r}, {x0 + r, y1 - r}, {x0 + r, y0 + r}, {x1 - r, y0 + r}};
    struct outline_pen pen = {o, {0, 0}, {0, 0}, false};

    for (uint32_t quarter = 0; quarter < 4; quarter++)
        for (uint32_t i = 0; i <= n; i++)
            outline_to(&pen, outline_at(centre[quarter], r, r,
                                        (uint16_t)((quarter * 16384 + i * (16384 / n)) & 65535)));
    outline_close(&pen);
}
