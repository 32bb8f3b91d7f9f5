/* fragment/source_map.c: places of an image. A stage; see source_map.h. */
#include "source_map.h"

ETCH_INLINE uint64_t step_wrap(uint64_t a, uint64_t b)
{
    return a + b;
}

/* The steps of a chunk's last pixel may lead out of 64 bits, but are not used. */
void etch_source_map(struct etch_chunk *c, const void *data)
{
    const struct etch_map *const m = (const struct etch_map *)data;
    uint64_t u = (uint64_t)(m->u + m->uy * c->y + m->ux * c->x);
    uint64_t v = (uint64_t)(m->v + m->vy * c->y + m->vx * c->x);

    for (uint16_t i = 0; i < c->n; i++) {
        c->u[i] = (int32_t)(uint32_t)(u >> 16 & UINT32_MAX);
        c->v[i] = (int32_t)(uint32_t)(v >> 16 & UINT32_MAX);
        c->a[i] = (uint16_t)ETCH_CHUNK_ALPHA_MAX;
        u = step_wrap(u, (uint64_t)m->ux);
        v = step_wrap(v, (uint64_t)m->vx);
    }
}
