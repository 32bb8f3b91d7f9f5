/* fragment/source_alpha.c: alpha linear on the screen. A stage; see source.h. */
#include "source.h"

/* 8.23 + 1/128 to 8.8 + 1/512, which rounds to nearest. */
#define LESS ((UINT32_C(1) << 16) - (UINT32_C(1) << 14))

void etch_source_alpha(struct etch_chunk *c, const void *data)
{
    const struct etch_staged_planes *const p = (const struct etch_staged_planes *)c->paint;
    const uint32_t da = p->color.linear.a.dx;
    uint32_t value = etch_plane_at(&p->color.linear.a, c->x, c->y);

    (void)data;
    for (uint16_t i = 0; i < c->n; i++) {
        /* the plane is 2^16 .. 255.01 2^23, and errs by less than 2^15 */
        const uint32_t a = value > LESS ? (value - LESS) >> 15 : 0;

        c->a[i] = (uint16_t)(a < ETCH_CHUNK_ALPHA_MAX ? a : ETCH_CHUNK_ALPHA_MAX);
        value = etch_wrap_add(value, da);
    }
}
