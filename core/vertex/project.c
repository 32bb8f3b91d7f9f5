/* vertex/project.c: the perspective division. Called by the mesh's vertex loop and by assembly,
 * once a vertex. See viewport.h. */
#include "viewport.h"

/* Position on one axis: 128 * (size * v / w + 2 * centre) in 1/256 px. Products below 2^16 *
 * 2^31 * 2^7. */
static int32_t place(int32_t size, int32_t twice_centre, etch_q16 v, etch_q16 w)
{
    return twice_centre * 128 + etch_divide_round_s64((int64_t)(size * 128) * v, w);
}

/* (z + w) / 2w of 65535, in 16.16: at most (2^32 - 2) * (2^32 - 2^16) + 2^31 < 2^64. */
static uint32_t depth(etch_q16 z, etch_q16 w)
{
    const uint64_t full = UINT64_C(65535) << 16;
    const uint64_t above = z > -w ? (uint64_t)((int64_t)z + w) : 0;

    if (z >= w)
        return (uint32_t)full;
    return (uint32_t)etch_divide_u64(above * full + (uint32_t)w, (uint64_t)w * 2).quotient;
}

void etch_viewport_project(const struct etch_viewport *v, const struct etch_clip_vertex *in,
                           struct etch_vertex *out)
{
    const struct etch_rect r = v->rect;

    out->x_q8 = place((int32_t)r.x1 - r.x0, (int32_t)r.x0 + r.x1, in->x, in->w);
    out->y_q8 = place(-((int32_t)r.y1 - r.y0), (int32_t)r.y0 + r.y1, in->y, in->w);
    out->z_q16 = depth(in->z, in->w);
    out->r = in->r;
    out->g = in->g;
    out->b = in->b;
    out->a = in->a;
}
