/* vertex/light_small.c: aiming a light in few bytes. Called by the application, once a draw. See
 * light_small.h. */
#include "light_small.h"
#include "project_small.h"

enum {
    LENGTH_Q14 = 16513
}; /* 2^21 / 127: a normal of length 127 along it gives 2^21 */

enum etch_status etch_light_aim_small(struct etch_light *light, const struct etch_matrix *model,
                                      const struct etch_vector *towards)
{
    int64_t local[3], most = 0;
    uint32_t square = 0;
    uint8_t shift = 0;

    /* The transpose, which is the inverse but for scale. Below 3 * 2^60. */
    for (uint8_t i = 0; i < 3; i++) {
        local[i] = etch_mul_s32(model->m[0][i], towards->x) +
                   etch_mul_s32(model->m[1][i], towards->y) +
                   etch_mul_s32(model->m[2][i], towards->z);
        most |= local[i] ^ local[i] >> 63;
    }
    if (most >> 15 == 0)
        return ETCH_EINVAL;
    for (; most >> 15 != 0; shift++)
        most >>= 1;
    for (uint8_t i = 0; i < 3; i++) {
        const int32_t v = (int32_t)(local[i] >> shift);

        square += (uint32_t)(v * v);
    }

    const uint16_t length = etch_sqrt_u32(square);
    int16_t *const to[3] = {&light->x, &light->y, &light->z};

    for (uint8_t i = 0; i < 3; i++) { /* below 2^15 16513 */
        const int32_t v = (int32_t)(local[i] >> shift) * LENGTH_Q14;
        const int32_t size = (int32_t)etch_divide_small((uint32_t)(v < 0 ? -v : v), length);

        *to[i] = (int16_t)(v < 0 ? -size : size);
    }
    return ETCH_OK;
}
