/* fragment/mipmap_vertex.c: texture coordinates in texels of a level. Called by applications for
 * each vertex, before drawing. See mipmap.h. */
#include "mipmap.h"

/* c part / whole, rounded half up. Where the whole is 2^level parts, a shift does it. */
static etch_q16 scaled(etch_q16 c, uint16_t part, uint16_t whole, uint8_t level)
{
    if ((uint32_t)part << level != whole)
        return etch_divide_round_s64(etch_mul_s32(c, part), whole);
    return level == 0 ? c : (c >> level) + (c >> (level - 1) & 1);
}

void etch_mipmap_vertex(struct etch_texture_vertex *out, const struct etch_texture_vertex *v,
                        const struct etch_mipmap *m, uint8_t level)
{
    const struct etch_image *const all = &m->level[0], *const some = &m->level[level];

    *out = *v;
    out->u = scaled(v->u, some->width, all->width, level);
    out->v = scaled(v->v, some->height, all->height, level);
}
