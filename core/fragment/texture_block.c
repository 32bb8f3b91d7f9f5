/* fragment/texture_block.c: pixels of a row in perspective, a divide every 16. Called by the
 * kernels that divide so. See texture_block.h. */
#include "texture_block.h"

ETCH_INLINE int32_t along(int32_t from, int32_t step, int32_t in)
{
    return (int32_t)etch_wrap_add((uint32_t)from, etch_wrap_mul((uint32_t)step, (uint32_t)in));
}

/* A block that reaches beyond the triangle may leave the range of the vertices. */
static ETCH_COLD void paint_held(uint16_t *pixel, int32_t n, struct etch_texel_offset at,
                                 struct etch_texel_offset step,
                                 const struct etch_perspective_paint *p)
{
    for (; n != 0; n--) {
        *pixel++ = etch_texel_held(p, at.u, at.v);
        at.u = along(at.u, step.u, 1);
        at.v = along(at.v, step.v, 1);
    }
}

/* Whether no pixel of n leaves the range: between the first and the last the rest lies. */
ETCH_INLINE bool holds_q16(const struct etch_perspective_axis *a, int32_t first, int32_t step,
                           int32_t n)
{
    const int32_t last = along(first, step, n - 1);

    return first >= a->least && first <= a->most && last >= a->least && last <= a->most;
}

/* n pixels from the one `in` columns into a block, whose coordinates are `from` at its beginning.
 * The difference of the ends in 1/4096 texel is the step in 16.16. */
ETCH_INLINE void paint_block(uint16_t *pixel, int32_t n, int32_t in,
                             const struct etch_texel_offset *from,
                             const struct etch_texel_offset *to, bool inside,
                             const struct etch_perspective_paint *p)
{
    const struct etch_texel_offset step = {along(to->u, from->u, -1), along(to->v, from->v, -1)};
    const struct etch_texel_offset at = {
        along((int32_t)etch_wrap_up((uint32_t)from->u, 4), step.u, in),
        along((int32_t)etch_wrap_up((uint32_t)from->v, 4), step.v, in)};

    const struct etch_perspective_planes *const c = &p->coordinates;

    if (inside || (holds_q16(&c->u, at.u, step.u, n) && holds_q16(&c->v, at.v, step.v, n))) {
        const struct etch_texel_walk walk = {
            etch_wrap_up(etch_wrap_add((uint32_t)at.u, c->u.middle), 4),
            etch_wrap_up(etch_wrap_add((uint32_t)at.v, c->v.middle), p->width_bits),
            etch_wrap_up((uint32_t)step.u, 4), etch_wrap_up((uint32_t)step.v, p->width_bits)};

        etch_texel_row(pixel, (uint32_t)n, &walk, &p->map);
    } else {
        paint_held(pixel, n, at, step, p);
    }
}

ETCH_INLINE bool holds(const struct etch_perspective_planes *c, const struct etch_texel_offset *at)
{
    return at->u >= c->u.least_q12 && at->u <= c->u.most_q12 && at->v >= c->v.least_q12 &&
           at->v <= c->v.most_q12;
}

void etch_texel_blocks(uint16_t *pixel, int32_t x, uint32_t n, int32_t y,
                       const struct etch_paint *paint)
{
    const struct etch_perspective_paint *const p = (const struct etch_perspective_paint *)paint;
    const struct etch_perspective_planes *const c = &p->coordinates;
    int32_t in = x & 15, left = (int32_t)n;
    struct etch_texel_ratio ratio = {etch_ratio_at(&c->u.numerator, x - in, y),
                                     etch_ratio_at(&c->v.numerator, x - in, y),
                                     etch_ratio_at(&c->denominator, x - in, y)};
    struct etch_texel_offset end[2], *from = &end[0], *to = &end[1];
    bool inside;

    etch_texel_divide(from, c, &ratio);
    inside = holds(c, from);
    do {
        const int32_t now = left < 16 - in ? left : 16 - in;
        struct etch_texel_offset *const next = from;
        bool here;

        ratio.u = along(ratio.u, (int32_t)c->u.numerator.dx, 16);
        ratio.v = along(ratio.v, (int32_t)c->v.numerator.dx, 16);
        ratio.d = along(ratio.d, (int32_t)c->denominator.dx, 16);
        etch_texel_divide(to, c, &ratio);
        here = holds(c, to);
        paint_block(pixel, now, in, from, to, inside && here, p);
        pixel += now, left -= now, in = 0;
        from = to, to = next, inside = here;
    } while (left != 0);
}
