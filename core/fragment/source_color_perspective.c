/* fragment/source_color_perspective.c: colours and alpha in perspective. A stage; see source.h. */
#include "source.h"
#include "weights.h"

/* 12 bits less, rounded to nearest, held to the range. */
static uint16_t value(const struct etch_perspective_colors *p, uint8_t i, struct etch_weight_pair w,
                      int32_t most)
{
    const int32_t v = (etch_weights_apply(w, p->base[i], p->one_q3[i], p->two_q3[i]) + 2048) >> 12;

    return (uint16_t)(v < 0 ? 0 : v > most ? most : v);
}

void etch_source_color_perspective(struct etch_chunk *c, const void *data)
{
    const struct etch_perspective_colors *const p =
        &((const struct etch_staged_planes *)c->paint)->color.perspective;

    (void)data;
    for (uint16_t i = 0; i < c->n; i++) {
        const struct etch_weight_pair w = etch_weights_at(&p->weights, (int16_t)(c->x + (int16_t)i),
                                                          c->y);

        c->r[i] = value(p, 0, w, (int32_t)ETCH_CHUNK_RED_MAX);
        c->g[i] = value(p, 1, w, (int32_t)ETCH_CHUNK_GREEN_MAX);
        c->b[i] = value(p, 2, w, (int32_t)ETCH_CHUNK_RED_MAX);
        c->a[i] = value(p, 3, w, (int32_t)ETCH_CHUNK_ALPHA_MAX);
    }
}
