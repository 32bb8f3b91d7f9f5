/* vertex/lamp_diffuse.c: lamps without specular light. Called once a vertex or pixel through a
 * pointer. See lamp.h. */
#include "lamp_sum.h"

void etch_shade_diffuse(const void *lighting, const struct etch_shade_point *point, uint8_t rgb[3])
{
    const struct etch_lamps *const lamps = lighting;
    struct lamp_sum sum = {{0, 0, 0}, {0, 0, 0}};

    for (uint8_t i = 0; i < lamps->count; i++) {
        struct etch_incidence in;

        lamps->lamp[i].kind(&lamps->lamp[i], point->position, &in);
        const int32_t n_l = etch_dot_q28(point->normal, in.towards);
        if (n_l > 0)
            lamp_add(sum.diffuse_q12, lamps->lamp[i].diffuse,
                     lamp_weight_q12(in.intensity_q16, n_l));
    }
    etch_lamp_finish(lamps, &sum, rgb);
}
