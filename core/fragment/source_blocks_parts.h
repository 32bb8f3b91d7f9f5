/* fragment/source_blocks_parts.h: what the stages of source_blocks.h are made from; no part of the
 * API. */
#ifndef ETCH_FRAGMENT_SOURCE_BLOCKS_PARTS_H
#define ETCH_FRAGMENT_SOURCE_BLOCKS_PARTS_H

#include "source_blocks.h"
#include "texture_divide.h"

ETCH_INLINE struct etch_texel_offset etch_block_end(const struct etch_perspective_planes *p,
                                                    int32_t x, int32_t y)
{
    const struct etch_texel_ratio at = {etch_ratio_at(&p->u.numerator, x, y),
                                        etch_ratio_at(&p->v.numerator, x, y),
                                        etch_ratio_at(&p->denominator, x, y)};
    struct etch_texel_offset offset;

    etch_texel_divide(&offset, p, &at);
    return offset;
}

/* n coordinates from the one `in` columns into a block of 2^bits. The ends are in 1/4096 texel, so
 * their difference is 16 steps in 16.16. */
ETCH_INLINE void etch_block_coordinates(int32_t *out, int32_t n, int32_t in, int32_t from,
                                        int32_t to, const struct etch_perspective_axis *a,
                                        const uint8_t bits)
{
    const uint32_t step = etch_wrap_up(etch_wrap_sub((uint32_t)to, (uint32_t)from),
                                       (uint8_t)(4 - bits));
    uint32_t at = etch_wrap_add(etch_wrap_up((uint32_t)from, 4), etch_wrap_mul(step, (uint32_t)in));

    for (; n > 0; n--) {
        *out++ = (int32_t)etch_texel_hold(a, (int32_t)at);
        at = etch_wrap_add(at, step);
    }
}

/* A chunk in blocks of 2^bits columns, bits 3 or 4. */
ETCH_INLINE void etch_source_in_blocks(struct etch_chunk *c, const uint8_t bits)
{
    const struct etch_perspective_planes *const p =
        &((const struct etch_staged_planes *)c->paint)->texture.perspective;
    const int32_t size = INT32_C(1) << bits;
    int32_t in = c->x & (size - 1), start = c->x - in, done = 0;
    struct etch_texel_offset from;

    if (!p->blocks) {
        etch_source_texture_perspective(c, NULL);
        return;
    }
    from = etch_block_end(p, start, c->y);
    while (done < c->n) {
        const struct etch_texel_offset to = etch_block_end(p, start + size, c->y);
        const int32_t left = c->n - done, n = left < size - in ? left : size - in;

        etch_block_coordinates(c->u + done, n, in, from.u, to.u, &p->u, bits);
        etch_block_coordinates(c->v + done, n, in, from.v, to.v, &p->v, bits);
        from = to;
        start += size, done += n, in = 0;
    }
}

#endif
