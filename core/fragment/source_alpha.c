/* fragment/source_alpha.c: alpha linear on the screen. A stage; see source.h. */
#include "source.h"

void etch_source_alpha(struct etch_chunk *c, const void *data)
{
    const struct etch_staged_planes *const p = (const struct etch_staged_planes *)c->paint;
    const uint32_t da = p->color.linear.a.dx;
    uint32_t value = etch_plane_at(&p->color.linear.a, c->x, c->y);

    (void)data;
    for (uint16_t i = 0; i < c->n; i++) {
        c->a[i] = (uint16_t)etch_chunk_alpha(value);
        value = etch_wrap_add(value, da);
    }
}
