/* fragment/source_texture_perspective.c: texture coordinates in perspective. A stage; see
 * source.h. */
#include "source.h"
#include "texture_divide.h"

void etch_source_texture_perspective(struct etch_chunk *c, const void *data)
{
    const struct etch_perspective_planes *const p =
        &((const struct etch_staged_planes *)c->paint)->texture.perspective;
    struct etch_texel_ratio at = {etch_ratio_at(&p->u.numerator, c->x, c->y),
                                  etch_ratio_at(&p->v.numerator, c->x, c->y),
                                  etch_ratio_at(&p->denominator, c->x, c->y)};

    (void)data;
    for (uint16_t i = 0; i < c->n; i++) {
        struct etch_texel_offset offset;

        etch_texel_divide(&offset, p, &at);
        c->u[i] = (int32_t)etch_texel_hold(&p->u, etch_texel_q16(offset.u));
        c->v[i] = (int32_t)etch_texel_hold(&p->v, etch_texel_q16(offset.v));
        at.u = (int32_t)etch_wrap_add((uint32_t)at.u, p->u.numerator.dx);
        at.v = (int32_t)etch_wrap_add((uint32_t)at.v, p->v.numerator.dx);
        at.d = (int32_t)etch_wrap_add((uint32_t)at.d, p->denominator.dx);
    }
}
