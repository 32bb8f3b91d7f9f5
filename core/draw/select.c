/* draw/select.c: a surface of one pixel that holds a name. Called by the application. See select.h.
 */
#include "select.h"

enum etch_status etch_select_init(struct etch_select *select, int16_t x, int16_t y,
                                  etch_kernel *kernel)
{
    const struct etch_rect window = {x, y, (int16_t)(x < INT16_MAX ? x + 1 : x),
                                     (int16_t)(y < INT16_MAX ? y + 1 : y)};

    if (etch_surface_init(&select->surface, &select->name, window, 1) != ETCH_OK)
        return ETCH_EINVAL;
    select->surface.depth = &select->depth;
    select->name = 0;
    select->depth = UINT16_MAX;
    etch_name_sink_init(&select->names, &select->surface, kernel);
    return ETCH_OK;
}
