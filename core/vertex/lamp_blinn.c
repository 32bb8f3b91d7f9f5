/* vertex/lamp_blinn.c: lamps with Blinn's specular light. Called once a vertex or pixel through a
 * pointer. See lamp.h. */
#include "lamp_sum.h"

/* N . H in 2.29. */
static int32_t half_way_q29(const int16_t normal[3], const int16_t towards[3],
                            const int16_t view[3])
{
    int32_t sum[3];
    int16_t half[3];

    for (int k = 0; k < 3; k++)
        sum[k] = (int32_t)towards[k] + view[k];
    (void)etch_unit_q14(half, sum);
    return etch_dot_q28(normal, half) * 2;
}

void etch_shade_blinn(const void *lighting, const struct etch_shade_point *point, uint8_t rgb[3])
{
    const struct etch_lamps *const lamps = lighting;
    struct lamp_sum sum = {{0, 0, 0}, {0, 0, 0}};
    int16_t view[3];

    lamp_view(view, lamps, point);
    for (uint8_t i = 0; i < lamps->count; i++) {
        const struct etch_lamp *const lamp = &lamps->lamp[i];
        struct etch_incidence in;

        lamp->kind(lamp, point->position, &in);
        const int32_t n_l = etch_dot_q28(point->normal, in.towards);
        if (n_l <= 0)
            continue;
        lamp_add(sum.diffuse_q12, lamp->diffuse, lamp_weight_q12(in.intensity_q16, n_l));
        const int32_t n_h = half_way_q29(point->normal, in.towards, view);
        if (n_h > 0)
            lamp_add(
                sum.specular_q12, lamp->specular,
                lamp_weight_q12(in.intensity_q16, lamp_power_q28(n_h, lamps->material->shininess)));
    }
    etch_lamp_finish(lamps, &sum, rgb);
}
