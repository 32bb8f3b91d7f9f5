/* draw/varying_color_perspective.c: colours and alpha in perspective. Named by pipelines, called by
 * staged.c. See staged.h. */
#include "../raster/weights.h"
#include "staged.h"

/* 5.26, 6.25, 5.26 and 8.23. */
static void channels(int32_t out[4], const struct etch_vertex *v)
{
    out[0] = (int32_t)((etch_channel_q27(v->r) - (UINT32_C(1) << 26)) >> 1);
    out[1] = (int32_t)((etch_channel_q26(v->g) - (UINT32_C(1) << 25)) >> 1);
    out[2] = (int32_t)((etch_channel_q27(v->b) - (UINT32_C(1) << 26)) >> 1);
    out[3] = v->a * (INT32_C(1) << 23);
}

void etch_varying_color_perspective(struct etch_staged_planes *planes,
                                    const struct etch_varying_input *in)
{
    struct etch_perspective_colors *const p = &planes->color.perspective;
    const uint8_t *const order = in->triangle->order;
    int32_t c[3][4];
    uint32_t w[3];

    for (uint8_t i = 0; i < 3; i++) {
        w[i] = ((const struct etch_texture_vertex *)in->v[i])->w;
        channels(c[i], in->v[order[i]]);
    }
    etch_weights_setup(&p->weights, in->triangle, w);
    for (uint8_t i = 0; i < 4; i++) {
        p->base[i] = c[0][i] >> 3;
        p->one_q3[i] = c[1][i] - c[0][i];
        p->two_q3[i] = c[2][i] - c[0][i];
    }
}
