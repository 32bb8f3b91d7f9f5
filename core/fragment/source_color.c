/* fragment/source_color.c: colours linear on the screen. A stage; see source.h. */
#include "source.h"

static void channel(uint16_t *out, const struct etch_chunk *c, const struct etch_plane *plane,
                    uint32_t half, uint32_t most)
{
    uint32_t value = etch_plane_at(plane, c->x, c->y);

    for (uint16_t i = 0; i < c->n; i++) {
        out[i] = (uint16_t)etch_chunk_channel(value, half, most);
        value = etch_wrap_add(value, plane->dx);
    }
}

void etch_source_color(struct etch_chunk *c, const void *data)
{
    const struct etch_staged_planes *const p = (const struct etch_staged_planes *)c->paint;

    (void)data;
    channel(c->r, c, &p->color.linear.r, UINT32_C(1) << 26, ETCH_CHUNK_RED_MAX);
    channel(c->g, c, &p->color.linear.g, UINT32_C(1) << 25, ETCH_CHUNK_GREEN_MAX);
    channel(c->b, c, &p->color.linear.b, UINT32_C(1) << 26, ETCH_CHUNK_RED_MAX);
}
