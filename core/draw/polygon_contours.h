/* draw/polygon_contours.h: what the polygon fills share; no part of the API. */
#ifndef ETCH_DRAW_POLYGON_CONTOURS_H
#define ETCH_DRAW_POLYGON_CONTOURS_H

#include "../fragment/flat.h"
#include "polygon.h"

ETCH_INLINE enum etch_status polygon_contours(struct etch_polygon *p, const struct etch_point *v,
                                              const uint16_t *size, uint16_t contours,
                                              struct etch_polygon_edge *edge, uint16_t room)
{
    etch_polygon_init(p, edge, room);
    for (uint16_t i = 0; i < contours; v += size[i++])
        (void)etch_polygon_add_pixels(p, v, size[i]);
    return p->status;
}

#endif
