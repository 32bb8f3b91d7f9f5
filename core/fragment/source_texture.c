/* fragment/source_texture.c: texture coordinates linear on the screen. A stage; see source.h. */
#include "source.h"

static void coordinate(int32_t *out, const struct etch_chunk *c,
                       const struct etch_linear_coordinate *p)
{
    uint32_t value = etch_plane_at(&p->plane, c->x, c->y);

    for (uint16_t i = 0; i < c->n; i++) {
        out[i] = (int32_t)etch_wrap_add((uint32_t)p->least, (uint32_t)((int32_t)value >> p->up));
        value = etch_wrap_add(value, p->plane.dx);
    }
}

void etch_source_texture(struct etch_chunk *c, const void *data)
{
    const struct etch_staged_planes *const p = (const struct etch_staged_planes *)c->paint;

    (void)data;
    coordinate(c->u, c, &p->texture.linear[0]);
    coordinate(c->v, c, &p->texture.linear[1]);
}
