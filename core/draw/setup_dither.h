/* draw/setup_dither.h: what the dithered flat painters share; no part of the API. */
#ifndef ETCH_DRAW_SETUP_DITHER_H
#define ETCH_DRAW_SETUP_DITHER_H

#include "dither.h"
#include "setup.h"

/* Planes that are one colour everywhere. */
ETCH_INLINE void setup_one_color(struct etch_gouraud_paint *p, const struct etch_vertex *v)
{
    p->r = (struct etch_plane){etch_channel_q27(v->r), 0, 0};
    p->g = (struct etch_plane){etch_channel_q26(v->g), 0, 0};
    p->b = (struct etch_plane){etch_channel_q27(v->b), 0, 0};
}

#endif
