/* vertex/light.h: colour of a lit vertex: ambient light and directional diffuse ones.
 *
 *      channel = min(255, color * (ambient + sum of diffuse * max(0, N . L)) / 255)
 *
 * N is the model's int8_t normal / 127 (not normalised again: length 127 is 1), L the unit
 * vector towards the light in model space. With the L given, the result errs from the exact
 * formula by at most 1/2 + 1/64 for its rounding and 1/32 for each light.
 */
#ifndef ETCH_VERTEX_LIGHT_H
#define ETCH_VERTEX_LIGHT_H

#include "matrix.h"

/* One directional light, ready for a draw. */
struct etch_light {
    int16_t x, y, z;    /* towards the light, in model space; length 2^21 / 127 */
    uint8_t diffuse[3]; /* r, g, b */
};

struct etch_lighting {
    uint8_t ambient[3];             /* r, g, b; add a material's emission here */
    uint8_t count;                  /* of lights, 0 .. 255 */
    const struct etch_light *light; /* the caller's */
};

/* Brings the direction towards a light (in world space, any length but zero) into the space of
 * a model placed by `model`, of which it uses the 3x3 part: rotations, mirrors and uniform
 * scales are right; other scales tilt the light. Leaves `diffuse`. Each component errs by at
 * most 1 unit. ETCH_EINVAL if the direction, there or here, is zero; *light is then unchanged.
 * Once per draw. */
enum etch_status etch_light_aim(struct etch_light *light, const struct etch_matrix *model,
                                const struct etch_vector *towards);

/* Replaces rgb, the vertex's own colour (255 each for a white one), by its lit colour. */
void etch_light_vertex(const struct etch_lighting *lighting, const int8_t normal[3],
                       uint8_t rgb[3]);

#endif
