/* fragment/stencil_update.c: the operations of pixels that passed the stencil test. A stage; see
 * stencil.h. */
#include "stencil_rows.h"

void etch_stage_stencil_update(struct etch_chunk *c, const void *data)
{
    const struct etch_stencil *const s = (const struct etch_stencil *)data;
    const uint32_t alive = c->alive;

    ETCH_ASSERT(c->surface->stencil != NULL);
    etch_stencil_apply(c, (uint16_t)(c->stencilled & ~alive), s, s->depth_fail);
    etch_stencil_apply(c, (uint16_t)(c->stencilled & alive), s, s->pass);
    c->stencilled = 0;
}
