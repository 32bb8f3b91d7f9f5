/* tests/oracle: round shapes by squares and cross products. See round.h. */
#include "round.h"
#include "circle.h"
#include "core/base/trig.h"

/* The point x / 2, y / 2. */
static bool in_ellipse(int64_t rx, int64_t ry, int64_t x, int64_t y)
{
    return x <= 2 * rx && y <= 2 * ry &&
           (uint64_t)(x * ry * x * ry) + (uint64_t)(y * rx * y * rx) <=
               (uint64_t)(4 * rx * ry * rx * ry);
}

bool oracle_ellipse_covers(int32_t rx, int32_t ry, int32_t dx, int32_t dy)
{
    const int64_t x = 2 * (dx < 0 ? -(int64_t)dx : dx), y = 2 * (dy < 0 ? -(int64_t)dy : dy);

    return rx >= 0 && ry >= 0 && x <= 4 * 32768 && y <= 4 * 32768 &&
           (in_ellipse(rx, ry, x - (x > 0), y) || in_ellipse(rx, ry, x, y - (y > 0)));
}

bool oracle_round_rect_covers(int32_t w, int32_t h, int32_t r, int32_t dx, int32_t dy)
{
    const int32_t most = ((w < h ? w : h) - 1) / 2, radius = r < 0 ? 0 : r > most ? most : r;
    const int32_t x = dx < radius ? dx - radius : dx > w - 1 - radius ? dx - (w - 1 - radius) : 0;
    const int32_t y = dy < radius ? dy - radius : dy > h - 1 - radius ? dy - (h - 1 - radius) : 0;

    return dx >= 0 && dy >= 0 && dx < w && dy < h && oracle_disc_covers(radius, x, y);
}

/* At or after the angle, within half a turn. */
static bool after(uint16_t angle, int64_t dx, int64_t dy)
{
    const int64_t ux = etch_cos_q30(angle), uy = etch_sin_q30(angle);
    const int64_t cross = ux * dy - uy * dx;

    return cross > 0 || (cross == 0 && ux * dx + uy * dy > 0);
}

bool oracle_sector_covers(uint16_t from, uint32_t sweep, int32_t dx, int32_t dy)
{
    const int32_t x = dx == 0 && dy == 0 ? 1 : dx;
    const uint16_t to = (uint16_t)(from + (sweep & 65535));

    if (sweep == 0 || sweep >= 65536)
        return sweep != 0;
    return sweep <= 32768 ? after(from, x, dy) && !after(to, x, dy)
                          : after(from, x, dy) || !after(to, x, dy);
}

bool oracle_arc_covers(int32_t outer, int32_t inner, uint16_t from, uint32_t sweep, int32_t dx,
                       int32_t dy)
{
    return oracle_disc_covers(outer, dx, dy) && !oracle_disc_covers(inner, dx, dy) &&
           oracle_sector_covers(from, sweep, dx, dy);
}
