/* vertex/light.c: diffuse light. Called by the lit vertex function, once a vertex, and by the
 * application, once a draw. See light.h. */
#include "light.h"
#include "vector.h"

enum {
    LENGTH_Q14 = 16513
}; /* 2^21 / 127: a normal of length 127 along it gives 2^21 */

enum etch_status etch_light_aim(struct etch_light *light, const struct etch_matrix *model,
                                const struct etch_vector *towards)
{
    const int64_t world[3] = {towards->x, towards->y, towards->z};
    int64_t local[3];
    int32_t unit[3];

    if (etch_vector_unit_q30(unit, world) != ETCH_OK)
        return ETCH_EINVAL;
    /* The transpose, which is the inverse but for scale. Sums at most 3 * 2^61. */
    for (int i = 0; i < 3; i++)
        local[i] = etch_mul_s32(model->m[0][i], unit[0]) + etch_mul_s32(model->m[1][i], unit[1]) +
                   etch_mul_s32(model->m[2][i], unit[2]);
    etch_vector_normalize_range(local);
    if (etch_vector_unit_q30(unit, local) != ETCH_OK)
        return ETCH_EINVAL;
    const int64_t half = INT64_C(1) << 29;
    light->x = (int16_t)((etch_mul_s32(unit[0], LENGTH_Q14) + half) >> 30);
    light->y = (int16_t)((etch_mul_s32(unit[1], LENGTH_Q14) + half) >> 30);
    light->z = (int16_t)((etch_mul_s32(unit[2], LENGTH_Q14) + half) >> 30);
    return ETCH_OK;
}

/* N . L in 4.12, not below 0. |N . L| <= 128 * 3 * 16513 < 2^23, so the result is below 2^14. */
static uint32_t intensity_q12(const struct etch_light *light, const int8_t normal[3])
{
    const int32_t dot_q21 = etch_mul_s16(light->x, normal[0]) + etch_mul_s16(light->y, normal[1]) +
                            etch_mul_s16(light->z, normal[2]);

    return dot_q21 <= 0 ? 0 : (uint32_t)(dot_q21 + 256) >> 9;
}

/* round(color * sum / 255), at most 255; sum_q12 is a channel's light, 255 = all of it. */
static uint8_t lit_channel(uint8_t color, uint32_t sum_q12)
{
    const uint32_t most = UINT32_C(65025) << 12; /* saturates every color but 0 */
    const uint32_t sum_q8 = ((sum_q12 < most ? sum_q12 : most) + 8) >> 4;
    const uint32_t product = (sum_q8 * color + 128) >> 8; /* below 2^32 before the shift */

    if (product >= 65025)
        return 255;
    return (uint8_t)((product + 128 + ((product + 128) >> 8)) >> 8); /* product / 255 */
}

void etch_light_vertex(const struct etch_lighting *lighting, const int8_t normal[3], uint8_t rgb[3])
{
    uint32_t sum_q12[3];

    for (int channel = 0; channel < 3; channel++)
        sum_q12[channel] = (uint32_t)lighting->ambient[channel] << 12;
    for (uint8_t i = 0; i < lighting->count; i++) { /* sums below 2^20 + 255 * 2^22 */
        const struct etch_light *light = &lighting->light[i];
        const uint32_t q12 = intensity_q12(light, normal);

        for (int channel = 0; channel < 3; channel++)
            sum_q12[channel] += light->diffuse[channel] * q12;
    }
    for (int channel = 0; channel < 3; channel++)
        rgb[channel] = lit_channel(rgb[channel], sum_q12[channel]);
}
