/* raster/texture_values.h: what planes in perspective are set up from; no part of the API. */
#ifndef ETCH_RASTER_TEXTURE_VALUES_H
#define ETCH_RASTER_TEXTURE_VALUES_H

#include "../base/texture.h"

/* q[i] = 2^30 least w / w[i], at least 1; the greatest is 2^29 .. 2^30. Returns the least. */
int32_t etch_texture_inverses(int32_t q[3], const struct etch_texture_vertex *const vertex[3]);

/* value[i] = (c[i] - middle) q[i] / 2^e + 2^29, 0 .. 2^30; fills in middle, least, most and
 * exponent. Returns e = 3 .. 33. */
int8_t etch_texture_numerators(struct etch_perspective_axis *a, uint32_t value[3],
                               const etch_q16 c[3], const int32_t q[3]);

#endif
