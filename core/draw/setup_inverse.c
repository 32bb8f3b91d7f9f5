/* draw/setup_inverse.c: the plane of a floating depth. Called by the painters of inverse.h. The
 * plane of depths whose vertices are q 2^up: so that of a far triangle is as exact for its size as
 * a near one's. */
#include "setup_inverse.h"

/* 65535.0 less depths of 15.0 and more; at most 2^32 - 2^20. */
static uint32_t distance_q16(uint32_t z_q16)
{
    const uint32_t far = UINT32_C(0xFFFF0000), near = UINT32_C(0x000F0000);

    return z_q16 >= far ? 0 : z_q16 <= near ? far - near : far - z_q16;
}

uint8_t etch_setup_inverse(struct etch_plane *z, const struct etch_triangle *t,
                           const struct etch_basis *basis, const struct etch_vertex *const v[3])
{
    struct etch_vertex inverse[3];
    const struct etch_vertex *const scaled[3] = {&inverse[0], &inverse[1], &inverse[2]};
    uint32_t all = 0;
    uint8_t up;

    for (uint8_t i = 0; i < 3; i++) {
        inverse[i].z_q16 = distance_q16(v[i]->z_q16);
        all |= inverse[i].z_q16;
    }
    up = etch_leading_zeros(all | 1);
    up = (uint8_t)(up == 0 ? 0 : up - 1);
    for (uint8_t i = 0; i < 3; i++)
        inverse[i].z_q16 <<= up;
    setup_depth(z, t, basis, scaled);
    return up;
}
