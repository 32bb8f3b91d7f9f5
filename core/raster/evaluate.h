/* raster/evaluate.h: several linear functions at every pixel of a rectangle, by additions alone.
 *
 * The building block of everything interpolated: gradients, height fields, tests of your own. A
 * plane (base/paint.h) is origin + x dx + y dy modulo 2^32; plane.h makes one from a triangle and
 * line_runs.h from a line, and signed values are two's complement.
 */
#ifndef ETCH_RASTER_EVALUATE_H
#define ETCH_RASTER_EVALUATE_H

#include "../base/paint.h"

/* Takes the values at pixel (x, y): value[k] == etch_plane_at(&plane[k], x, y), exactly. */
typedef void etch_evaluate_function(void *context, int16_t x, int16_t y, const uint32_t *value);

/* Calls the function for every pixel of `rect`, rows from top to bottom, each from left to right.
 * `plane` holds `count` planes, and `work` has room for 2 * count values: the caller's, so that any
 * number will do. An empty rectangle calls nothing. Two multiplications a plane, then one addition
 * a value for each pixel and two for each row. */
void etch_evaluate_rect(const struct etch_plane *plane, uint8_t count, struct etch_rect rect,
                        uint32_t *work, etch_evaluate_function *function, void *context);

#endif
