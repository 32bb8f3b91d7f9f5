/* wp: slope_of,times_rest,times,rounded,etch_plane_setup
 * spec: etch_divide_u64
 * proved: exact plane equations (raster/plane.c), for every triangle of vertices in -2^23 ..
 *          2^23 and every values: nothing overflows, every rest stays below the area
 * assumed: what etch_divide_u64 promises (divide.c) */
#include "prove.h"
#include "core/raster/plane.c"

void prove(void)
{
    struct etch_plane plane;
    struct etch_triangle t;
    uint32_t value[3] = {ANY_U32, ANY_U32, ANY_U32};

    for (int i = 0; i < 3; i++) {
        t.p[i].x = (int32_t)any(-8388608, 8388608);
        t.p[i].y = (int32_t)any(-8388608, 8388608);
        t.order[i] = (uint8_t)any(0, 2);
    }
    t.side = any(0, 1) == 0 ? 1 : -1;
    t.area = any_unsigned(1, UINT64_C(1) << 48);
    etch_plane_setup(&plane, &t, value);
}
