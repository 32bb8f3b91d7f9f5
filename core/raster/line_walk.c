/* raster/line_walk.c: the pixels of a line. Called by line.c. See line_walk.h. */
#include "line_walk.h"

/* Where a walk stands: the pixel written last, and e as below. */
struct pen {
    uint16_t *p;
    int32_t e;
};

/* Two pixels on. With 2 dv <= du at most one of two steps goes aside: one decision for both. */
ETCH_INLINE void two_steps(struct pen *pen, ptrdiff_t along, ptrdiff_t aside, int32_t du,
                           int32_t dv, uint16_t color)
{
    uint16_t *p = pen->p;
    int32_t e = pen->e + 2 * dv;

    if (e < 0) {
        p += along;
        *p = color;
        p += along;
        *p = color;
    } else {
        if (e >= dv) {
            p += aside;
            *p = color;
            p += along;
        } else {
            p += along;
            *p = color;
            p += aside;
        }
        *p = color;
        e -= du;
    }
    pen->p = p;
    pen->e = e;
}

void etch_line_walk(uint16_t *p, uint32_t n, ptrdiff_t along, ptrdiff_t aside, int32_t e,
                    int32_t du, int32_t dv, uint16_t color)
{
    struct pen pen = {p, e};

    *p = color;
    if ((n & 1) != 0) {
        pen.e += dv;
        pen.p += pen.e >= 0 ? aside : along;
        pen.e -= pen.e >= 0 ? du : 0;
        *pen.p = color;
    }
    for (uint32_t i = n & 6; i != 0; i -= 2)
        two_steps(&pen, along, aside, du, dv, color);
    for (n >>= 3; n != 0; n--) {
        ETCH_UNROLL(4)
        for (uint8_t i = 0; i < 4; i++)
            two_steps(&pen, along, aside, du, dv, color);
    }
}
