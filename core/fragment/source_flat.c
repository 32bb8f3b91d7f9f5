/* fragment/source_flat.c: one colour for all pixels. A stage; see source.h. */
#include "source.h"

void etch_source_flat(struct etch_chunk *c, const void *data)
{
    const uint16_t *const flat = ((const struct etch_staged_planes *)c->paint)->color.flat;

    (void)data;
    for (uint16_t i = 0; i < c->n; i++) {
        c->r[i] = flat[0];
        c->g[i] = flat[1];
        c->b[i] = flat[2];
        c->a[i] = flat[3];
    }
}
