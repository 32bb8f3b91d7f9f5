/* fragment/phong.c: lit pixels. A stage; see phong.h. */
#include "phong.h"
#include "../base/unit.h"
#include "weights.h"

static int32_t value(const struct etch_phong_value *v, struct etch_weight_pair w)
{
    return etch_weights_apply(w, v->base, v->one_q3, v->two_q3);
}

static void set_point(struct etch_shade_point *point, const struct etch_phong_planes *p, int16_t x,
                      int16_t y)
{
    const struct etch_weight_pair w = etch_weights_at(&p->weights, x, y);
    const int32_t normal[3] = {value(&p->normal[0], w), value(&p->normal[1], w),
                               value(&p->normal[2], w)};

    (void)etch_unit_q14(point->normal, normal);
    for (uint8_t i = 0; i < 3; i++)
        point->position[i] = etch_saturate_s32(value(&p->position[i], w) *
                                               (INT64_C(1) << p->position_down));
}

/* v of `most`, most < 2^17, to 0 .. 255 and back, rounded. */
static uint8_t to_byte(uint16_t v, uint32_t most)
{
    return (uint8_t)((v * UINT32_C(255) + most / 2) / most);
}

static uint16_t from_byte(uint8_t v, uint32_t most)
{
    return (uint16_t)((v * most + 127) / 255);
}

void etch_stage_phong(struct etch_chunk *c, const void *data)
{
    const struct etch_phong_planes *const p = (const struct etch_phong_planes *)(const void *)
                                                  c->paint;
    const struct etch_phong *const phong = data;

    for (uint16_t i = 0; i < c->n; i++) {
        struct etch_shade_point point;
        uint8_t rgb[3];

        if ((c->alive >> i & 1) == 0)
            continue;
        set_point(&point, p, (int16_t)(c->x + (int16_t)i), c->y);
        rgb[0] = to_byte(c->r[i], ETCH_CHUNK_RED_MAX);
        rgb[1] = to_byte(c->g[i], ETCH_CHUNK_GREEN_MAX);
        rgb[2] = to_byte(c->b[i], ETCH_CHUNK_RED_MAX);
        phong->shade(phong->lighting, &point, rgb);
        c->r[i] = from_byte(rgb[0], ETCH_CHUNK_RED_MAX);
        c->g[i] = from_byte(rgb[1], ETCH_CHUNK_GREEN_MAX);
        c->b[i] = from_byte(rgb[2], ETCH_CHUNK_RED_MAX);
    }
}
