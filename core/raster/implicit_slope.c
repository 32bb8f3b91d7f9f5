/* raster/implicit_slope.c: what a Lipschitz bound says of a tile. Called by implicit.c. See
 * implicit.h. */
#include "implicit.h"

enum etch_implicit_side etch_implicit_side_slope(const struct etch_implicit *shape,
                                                 struct etch_rect tile)
{
    const int32_t w = (int32_t)tile.x1 - tile.x0, h = (int32_t)tile.y1 - tile.y0;
    const int16_t x = (int16_t)(tile.x0 + w / 2), y = (int16_t)(tile.y0 + h / 2);
    const int64_t f = shape->value(shape, x, y);
    const int64_t reach = (int64_t)(w / 2 + h / 2) * shape->slope; /* to the upper left corner */

    return f + reach < 0    ? ETCH_IMPLICIT_INSIDE
           : f - reach >= 0 ? ETCH_IMPLICIT_OUTSIDE
                            : ETCH_IMPLICIT_UNKNOWN;
}
