/* fragment/logic.c: raster operations. Stages; see logic.h. */
#include "logic.h"
#include "write.h"

#define STAGE(name, expression)                                                                    \
    void etch_stage_logic_##name(struct etch_chunk *c, const void *data)                           \
    {                                                                                              \
        (void)data;                                                                                \
        for (uint16_t i = 0; i < c->n; i++) {                                                      \
            const uint32_t s = etch_chunk_pixel(c, i), d = c->pixel[i];                            \
                                                                                                   \
            (void)s, (void)d;                                                                      \
            etch_chunk_set_pixel(c, i, (uint16_t)(UINT32_C(0xFFFF) & (expression)));               \
        }                                                                                          \
    }

STAGE(clear, UINT32_C(0))
STAGE(and, s &d)
STAGE(and_reverse, s & ~d)
STAGE(copy, s)
STAGE(and_inverted, ~s &d)
STAGE(noop, d)
STAGE(xor, s ^ d)
STAGE(or, s | d)
STAGE(nor, ~(s | d))
STAGE(equiv, ~(s ^ d))
STAGE(invert, ~d)
STAGE(or_reverse, s | ~d)
STAGE(copy_inverted, ~s)
STAGE(or_inverted, ~s | d)
STAGE(nand, ~(s &d))
STAGE(set, UINT32_C(0xFFFF))
