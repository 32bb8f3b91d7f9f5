/* fragment/source_depth.c: depth linear on the screen. A stage; see source.h. */
#include "source.h"

void etch_source_depth(struct etch_chunk *c, const void *data)
{
    const struct etch_plane *const plane = &((const struct etch_staged_planes *)c->paint)->z;
    uint32_t z = etch_plane_at(plane, c->x, c->y);

    (void)data;
    for (uint16_t i = 0; i < c->n; i++) {
        c->z[i] = (uint16_t)(z >> 16);
        z = etch_wrap_add(z, plane->dx);
    }
}
