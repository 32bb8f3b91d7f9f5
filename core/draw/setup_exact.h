/* draw/setup_exact.h: what the exact triangle painters share; no part of the API. */
#ifndef ETCH_DRAW_SETUP_EXACT_H
#define ETCH_DRAW_SETUP_EXACT_H

#include "../raster/plane_exact.h"
#include "exact.h"
#include "setup.h"

/* 2 full c + 255 of 255 D's doubled: a channel is floor(N / 510 D). */
void etch_setup_exact_color(struct etch_gouraud_exact_paint *paint, const struct etch_triangle *t,
                            const struct etch_vertex *const v[3]);
void etch_setup_exact_depth(struct etch_exact_depth *depth, const struct etch_triangle *t,
                            const struct etch_vertex *const v[3]);

#endif
