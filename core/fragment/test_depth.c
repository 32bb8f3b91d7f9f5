/* fragment/test_depth.c: drops pixels by their depth; stores depths. Stages; see test.h. */
#include "template.h"
#include "test.h"

ETCH_INLINE void test(struct etch_chunk *c, etch_depth_test *passes)
{
    const uint16_t *const stored = c->surface->depth + c->first;
    uint16_t keep = 0;

    ETCH_ASSERT(c->surface->depth != NULL);
    for (uint16_t i = 0, bit = 1; i < c->n; i++, bit = (uint16_t)((uint32_t)bit << 1 & 0xFFFF))
        keep = (uint16_t)(keep | (passes(c->z[i], stored[i]) ? bit : 0));
    c->alive &= keep;
}

#define STAGE(name)                                                                                \
    void etch_stage_depth_##name(struct etch_chunk *c, const void *data)                           \
    {                                                                                              \
        (void)data;                                                                                \
        test(c, etch_depth_##name);                                                                \
    }

STAGE(never)
STAGE(less)
STAGE(equal)
STAGE(lequal)
STAGE(greater)
STAGE(notequal)
STAGE(gequal)

void etch_stage_depth_write(struct etch_chunk *c, const void *data)
{
    uint16_t *const stored = c->surface->depth + c->first;

    (void)data;
    ETCH_ASSERT(c->surface->depth != NULL);
    for (uint16_t i = 0, left = c->alive; left != 0; i++, left >>= 1)
        if ((left & 1) != 0)
            stored[i] = c->z[i];
}
