/* vertex/light_small.h: aiming a light, for programs that count bytes. */
#ifndef ETCH_VERTEX_LIGHT_SMALL_H
#define ETCH_VERTEX_LIGHT_SMALL_H

#include "light.h"

/* As etch_light_aim (light.h) for |towards| < 8192.0 each, but components err by up to 4 units of
 * 16513, and directions below 2^-16 in the model's space are refused like zero. */
enum etch_status etch_light_aim_small(struct etch_light *light, const struct etch_matrix *model,
                                      const struct etch_vector *towards);

#endif
