/* fragment/stencil_rows.h: what the stencil stages share; no part of the API. */
#ifndef ETCH_FRAGMENT_STENCIL_ROWS_H
#define ETCH_FRAGMENT_STENCIL_ROWS_H

#include "stencil.h"

/* Applies an operation to the pixels whose bits are set. */
ETCH_INLINE void etch_stencil_apply(const struct etch_chunk *c, uint16_t pixels,
                                    const struct etch_stencil *s, etch_stencil_operation *operation)
{
    uint8_t *stored = c->surface->stencil + c->first;

    if (operation == NULL)
        return;
    for (; pixels != 0; pixels >>= 1, stored++)
        if ((pixels & 1) != 0)
            *stored = (uint8_t)((*stored & ~(uint32_t)s->write_mask) |
                                (operation(*stored, s->reference) & (uint32_t)s->write_mask));
}

#endif
