/* draw/mesh_phong.c: normals and positions of a triangle. Named by pipelines, called by staged.c.
 * See mesh_phong.h. */
#include "mesh_phong.h"
#include "../raster/weights.h"

static uint32_t distance(int32_t a, int32_t b)
{
    return a > b ? etch_wrap_sub((uint32_t)a, (uint32_t)b)
                 : etch_wrap_sub((uint32_t)b, (uint32_t)a);
}

/* `down` makes the differences fit 28 bits. */
static void set_value(struct etch_phong_value *v, int32_t a, int32_t b, int32_t c, uint8_t down)
{
    v->base = a >> down;
    v->one_q3 = ((b >> down) - v->base) * 8;
    v->two_q3 = ((c >> down) - v->base) * 8;
}

void etch_varying_shade(struct etch_staged_planes *planes, const struct etch_varying_input *in)
{
    struct etch_phong_planes *const p = (struct etch_phong_planes *)(void *)planes;
    const struct etch_shade_vertex *v[3]; /* sorted */
    uint32_t w[3], most = 0;

    for (uint8_t i = 0; i < 3; i++) {
        w[i] = ((const struct etch_texture_vertex *)(const void *)in->v[i])->w;
        v[i] = (const struct etch_shade_vertex *)(const void *)in->v[in->triangle->order[i]];
    }
    etch_weights_setup(&p->weights, in->triangle, w);
    for (uint8_t i = 0; i < 3; i++) {
        most |= distance(v[0]->position[i], v[1]->position[i]);
        most |= distance(v[0]->position[i], v[2]->position[i]);
    }
    p->position_down = 0;
    while (most >> p->position_down >= UINT32_C(1) << 28)
        p->position_down++;
    p->position_down = (uint8_t)(p->position_down + (p->position_down != 0));
    for (uint8_t i = 0; i < 3; i++) {
        set_value(&p->normal[i], v[0]->normal[i] * 1024, v[1]->normal[i] * 1024,
                  v[2]->normal[i] * 1024, 0);
        set_value(&p->position[i], v[0]->position[i], v[1]->position[i], v[2]->position[i],
                  p->position_down);
    }
}
