/* fragment/test_alpha.c: drops pixels by their alpha. A stage; see test.h. */
#include "test.h"

void etch_stage_alpha_gequal(struct etch_chunk *c, const void *data)
{
    const uint16_t least = (uint16_t)(((const struct etch_alpha_test *)data)->reference * 256U);
    uint16_t keep = 0;

    for (uint16_t i = 0, bit = 1; i < c->n; i++, bit = (uint16_t)((uint32_t)bit << 1 & 0xFFFF))
        keep = (uint16_t)(keep | (c->a[i] >= least ? bit : 0));
    c->alive &= keep;
}
