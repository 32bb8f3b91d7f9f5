/* leaf/vector128/project.c: etch_viewport_project by the divider of a 64-bit core, in place of
 * vertex/project.c, which makes the same quotients from one reciprocal. Called by the mesh's vertex
 * loop and by assembly, once a vertex. */
#include "../../vertex/viewport.h"

/* n / d rounded down, d > 0. */
static int32_t floor_of(int64_t n, int64_t d)
{
    const int64_t quotient = n / d;

    return (int32_t)(quotient - (n - quotient * d < 0 ? 1 : 0));
}

/* 128 size v / w rounded half up: |size| <= 2^16, so the sum is below 2^56. */
static int32_t place(int32_t size, etch_q16 v, etch_q16 w)
{
    return floor_of((int64_t)size * 256 * v + w, (int64_t)w * 2);
}

void etch_viewport_project(const struct etch_viewport *v, const struct etch_clip_vertex *in,
                           struct etch_vertex *out)
{
    const struct etch_rect *const r = &v->rect;
    const int32_t x0 = r->x0, x1 = r->x1, y0 = r->y0, y1 = r->y1;
    const int64_t w = in->w, sum = in->z + w;
    const int64_t above = sum < 0 ? 0 : sum > 2 * w ? 2 * w : sum; /* a rounded corner's */

    out->x_q8 = place(x1 - x0, in->x, in->w) + (x0 + x1) * 128;
    out->y_q8 = place(y0 - y1, in->y, in->w) + (y0 + y1) * 128;
    /* at most (2^32 - 2) (2^32 - 2^16) + 2^31 < 2^64 */
    out->z_q16 = (uint32_t)(((uint64_t)above * UINT32_C(0xFFFF0000) + (uint64_t)w) /
                            ((uint64_t)w * 2));
    out->r = in->r;
    out->g = in->g;
    out->b = in->b;
    out->a = in->a;
}
