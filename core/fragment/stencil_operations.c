/* fragment/stencil_operations.c: what may happen to a stencil value. Named by struct etch_stencil,
 * called by its stages. See stencil.h. */
#include "stencil.h"

uint8_t etch_stencil_zero(uint8_t stored, uint8_t reference)
{
    (void)stored, (void)reference;
    return 0;
}

uint8_t etch_stencil_replace(uint8_t stored, uint8_t reference)
{
    (void)stored;
    return reference;
}

uint8_t etch_stencil_incr(uint8_t stored, uint8_t reference)
{
    (void)reference;
    return stored < 255 ? (uint8_t)(stored + 1) : 255;
}

uint8_t etch_stencil_decr(uint8_t stored, uint8_t reference)
{
    (void)reference;
    return stored > 0 ? (uint8_t)(stored - 1) : 0;
}

uint8_t etch_stencil_invert(uint8_t stored, uint8_t reference)
{
    (void)reference;
    return (uint8_t)(255 - stored);
}

uint8_t etch_stencil_incr_wrap(uint8_t stored, uint8_t reference)
{
    (void)reference;
    return stored < 255 ? (uint8_t)(stored + 1) : 0;
}

uint8_t etch_stencil_decr_wrap(uint8_t stored, uint8_t reference)
{
    (void)reference;
    return stored > 0 ? (uint8_t)(stored - 1) : 255;
}
