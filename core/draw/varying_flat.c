/* draw/varying_flat.c: the colour of vertex 0. Named by pipelines, called by staged.c. See
 * staged.h. */
#include "staged.h"

void etch_varying_flat(struct etch_staged_planes *planes, const struct etch_varying_input *in)
{
    const struct etch_vertex *const v = in->v[0];
    uint16_t *const flat = planes->color.flat;

    /* as the plane of three equal colours: what 16 bits cannot hold is cut */
    flat[0] = (uint16_t)((etch_channel_q27(v->r) - (UINT32_C(1) << 26)) >> 16);
    flat[1] = (uint16_t)((etch_channel_q26(v->g) - (UINT32_C(1) << 25)) >> 16);
    flat[2] = (uint16_t)((etch_channel_q27(v->b) - (UINT32_C(1) << 26)) >> 16);
    flat[3] = (uint16_t)(v->a * 256U);
}
