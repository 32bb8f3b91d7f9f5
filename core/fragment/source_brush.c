/* fragment/source_brush.c: a brush in a pipeline. A stage; see brush.h. */
#include "brush.h"
#include "write.h"

void etch_source_brush(struct etch_chunk *c, const void *data)
{
    const struct etch_brush *const brush = data;
    uint16_t color[ETCH_CHUNK];

    brush->colors(brush, c->x, c->y, c->n, color);
    for (uint16_t i = 0; i < c->n; i++) {
        etch_chunk_set_pixel(c, i, color[i]);
        c->a[i] = (uint16_t)ETCH_CHUNK_ALPHA_MAX;
    }
}
