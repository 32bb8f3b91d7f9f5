/* fragment/test_stencil.c: drops pixels by their stencil value. Stages; see stencil.h. */
#include "stencil_rows.h"
#include "template.h"

ETCH_INLINE void test(struct etch_chunk *c, const struct etch_stencil *s, etch_depth_test *passes)
{
    const uint8_t *const stored = c->surface->stencil + c->first;
    const uint16_t reference = (uint16_t)(s->reference & (uint32_t)s->mask);
    uint16_t keep = 0;

    ETCH_ASSERT(c->surface->stencil != NULL);
    for (uint16_t i = 0, bit = 1; i < c->n; i++, bit = (uint16_t)((uint32_t)bit << 1 & 0xFFFF)) {
        const uint16_t value = (uint16_t)(stored[i] & (uint32_t)s->mask);

        keep = (uint16_t)(keep | (passes(reference, value) ? bit : 0));
    }
    etch_stencil_apply(c, (uint16_t)(c->alive & ~(uint32_t)keep), s, s->fail);
    c->alive &= keep;
    c->stencilled = c->alive;
}

#define STAGE(name)                                                                                \
    void etch_stage_stencil_##name(struct etch_chunk *c, const void *data)                         \
    {                                                                                              \
        test(c, (const struct etch_stencil *)data, etch_depth_##name);                             \
    }

STAGE(never)
STAGE(less)
STAGE(equal)
STAGE(lequal)
STAGE(greater)
STAGE(notequal)
STAGE(gequal)
STAGE(always)
