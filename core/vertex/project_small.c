/* vertex/project_small.c: the perspective division in few bytes. Called by assembly_small. See
 * project_small.h. */
#include "project_small.h"

uint32_t etch_divide_small(uint64_t n, uint32_t d)
{
    uint32_t rest = (uint32_t)(n >> 32), low = (uint32_t)(n & UINT32_MAX); /* rest < d */

    for (uint8_t i = 32; i != 0; i--) { /* low gives its bits and takes the quotient's */
        const bool carry = rest >> 31 != 0;

        rest = etch_wrap_add(etch_wrap_add(rest, rest), low >> 31);
        low = etch_wrap_add(low, low);
        if (carry || rest >= d)
            rest = etch_wrap_sub(rest, d), low |= 1;
    }
    return low;
}

/* 128 size v / w rounded half up, |result| < 2^24: with 2^24 w more nothing is negative. */
static ETCH_COLD int32_t place(int32_t size, etch_q16 v, etch_q16 w)
{
    const int64_t n = etch_mul_s32(size * 128, v) + etch_mul_s32(w, INT32_C(1) << 24) + (w >> 1);

    return (int32_t)etch_divide_small((uint64_t)n, (uint32_t)w) - (INT32_C(1) << 24);
}

void etch_viewport_project_small(const struct etch_viewport *v, const struct etch_clip_vertex *in,
                                 struct etch_vertex *out)
{
    const struct etch_rect *r = &v->rect;
    const int32_t x0 = r->x0, x1 = r->x1, y0 = r->y0, y1 = r->y1;
    const etch_q16 w = in->w;
    /* a clipped corner's z may be rounded beyond -w .. w */
    const etch_q16 z = in->z > w ? w : in->z < -w ? -w : in->z;

    out->x_q8 = place(x1 - x0, in->x, w) + (x0 + x1) * 128;
    out->y_q8 = place(y0 - y1, in->y, w) + (y0 + y1) * 128;
    /* (z + w) / 2 w of 65535 in 16.16; below 2^32 2^32 */
    out->z_q16 = etch_divide_small((uint64_t)((int64_t)z + w) * UINT32_C(0xFFFF0000) + (uint32_t)w,
                                   (uint32_t)w * 2);
    out->r = in->r;
    out->g = in->g;
    out->b = in->b;
    out->a = in->a;
}
