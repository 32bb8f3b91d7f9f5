/* vertex/lamp_finish.c: sums of light and a material to a colour. Called by the shade functions.
 * See lamp_sum.h. */
#include "lamp_sum.h"

/* Light in 8.12, at most 8 times all of it, by what the surface returns of it, material * color /
 * 255: 255 times the channel in 9 fraction bits. */
static uint32_t lit_q9(uint32_t light_q12, uint8_t material, uint8_t color)
{
    const uint32_t most = UINT32_C(2040) << 12;
    const uint32_t light = light_q12 < most ? light_q12 : most;
    const uint32_t product = (uint32_t)material * color;
    /* product * 256 / 255 = product + product / 255, rounded: 8.8 */
    const uint32_t surface = product + ((product + 128 + ((product + 128) >> 8)) >> 8);

    return (uint32_t)etch_mul_high((int32_t)(light << 7), (int32_t)(surface << 14));
}

void etch_lamp_finish(const struct etch_lamps *lamps, const struct lamp_sum *sum, uint8_t rgb[3])
{
    const struct etch_material *const m = lamps->material;

    for (int k = 0; k < 3; k++) { /* below 3 * 2^28 + 2^25 */
        const uint32_t all_q9 = lit_q9((uint32_t)lamps->ambient[k] << 12, m->ambient[k], rgb[k]) +
                                lit_q9(sum->diffuse_q12[k], m->diffuse[k], rgb[k]) +
                                lit_q9(sum->specular_q12[k], m->specular[k], 255) +
                                (UINT32_C(255) * m->emission[k] << 9);
        const uint32_t all = (all_q9 + 256) >> 9;

        rgb[k] = (uint8_t)(all >= 65025 ? 255 : (all + 128 + ((all + 128) >> 8)) >> 8);
    }
}
