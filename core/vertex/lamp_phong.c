/* vertex/lamp_phong.c: lamps with Phong's specular light. Called once a vertex or pixel through a
 * pointer. See lamp.h. */
#include "lamp_sum.h"

/* R . V = 2 (N . L) (N . V) - L . V in 2.29, N . L > 0; (N . L) (N . V) within 2^-28. */
static int32_t mirrored_q29(int32_t n_l, int32_t n_v, int32_t l_v)
{
    return etch_mul_high(n_v * 4, n_l * 4) * 4 - l_v * 2;
}

void etch_shade_phong(const void *lighting, const struct etch_shade_point *point, uint8_t rgb[3])
{
    const struct etch_lamps *const lamps = lighting;
    struct lamp_sum sum = {{0, 0, 0}, {0, 0, 0}};
    int16_t view[3];

    lamp_view(view, lamps, point);
    const int32_t n_v = etch_dot_q28(point->normal, view);
    for (uint8_t i = 0; i < lamps->count; i++) {
        const struct etch_lamp *const lamp = &lamps->lamp[i];
        struct etch_incidence in;

        lamp->kind(lamp, point->position, &in);
        const int32_t n_l = etch_dot_q28(point->normal, in.towards);
        if (n_l <= 0)
            continue;
        lamp_add(sum.diffuse_q12, lamp->diffuse, lamp_weight_q12(in.intensity_q16, n_l));
        const int32_t r_v = mirrored_q29(n_l, n_v, etch_dot_q28(in.towards, view));
        if (r_v > 0)
            lamp_add(
                sum.specular_q12, lamp->specular,
                lamp_weight_q12(in.intensity_q16, lamp_power_q28(r_v, lamps->material->shininess)));
    }
    etch_lamp_finish(lamps, &sum, rgb);
}
