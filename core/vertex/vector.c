/* vertex/vector.c: unit vectors and cross products. Called by the set-up of matrices and
 * lights, a few times a frame. See vector.h. */
#include "vector.h"

static uint64_t magnitude(const int64_t v[3])
{
    /* v ^ sign is |v| or |v| - 1: enough to find the leading bit. */
    return (uint64_t)(v[0] ^ (v[0] >> 63)) | (uint64_t)(v[1] ^ (v[1] >> 63)) |
           (uint64_t)(v[2] ^ (v[2] >> 63));
}

void etch_vector_normalize_range(int64_t v[3])
{
    uint64_t size = magnitude(v);

    if (v[0] == 0 && v[1] == 0 && v[2] == 0)
        return;
    for (; size >= UINT64_C(1) << 30; size >>= 1) {
        v[0] >>= 1;
        v[1] >>= 1;
        v[2] >>= 1;
    }
    for (; size < UINT64_C(1) << 29; size = magnitude(v)) {
        v[0] *= 2;
        v[1] *= 2;
        v[2] *= 2;
    }
}

/* floor(sqrt(v)), v < 2^62, one bit a step as in base/sqrt.c. */
static uint32_t sqrt_u62(uint64_t v)
{
    uint64_t root = 0;

    for (uint64_t bit = UINT64_C(1) << 60; bit != 0; bit >>= 2) {
        if (v >= root + bit) {
            v -= root + bit;
            root = (root >> 1) + bit;
        } else {
            root >>= 1;
        }
    }
    return (uint32_t)root;
}

enum etch_status etch_vector_unit_q30(int32_t unit[3], const int64_t v[3])
{
    int64_t scaled[3] = {v[0], v[1], v[2]};

    if (v[0] == 0 && v[1] == 0 && v[2] == 0)
        return ETCH_EINVAL;
    etch_vector_normalize_range(scaled); /* squares sum below 3 * 2^60, their root over 2^29 */
    const uint64_t squares = (uint64_t)(scaled[0] * scaled[0]) + (uint64_t)(scaled[1] * scaled[1]) +
                             (uint64_t)(scaled[2] * scaled[2]);
    const uint32_t length = sqrt_u62(squares);
    for (int i = 0; i < 3; i++)
        unit[i] = etch_divide_round_s64(scaled[i] * (INT64_C(1) << 30), length);
    return ETCH_OK;
}

void etch_vector_cross(int64_t cross[3], const int32_t a[3], const int32_t b[3])
{
    cross[0] = etch_mul_s32(a[1], b[2]) - etch_mul_s32(a[2], b[1]);
    cross[1] = etch_mul_s32(a[2], b[0]) - etch_mul_s32(a[0], b[2]);
    cross[2] = etch_mul_s32(a[0], b[1]) - etch_mul_s32(a[1], b[0]);
}
