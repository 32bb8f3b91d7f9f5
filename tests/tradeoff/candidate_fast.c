/* tradeoff/candidate_fast.c: cheap colour planes: steps of the barycentric weights, shared by the
 * channels. See candidates.h.
 *
 * A channel is c0 + d1 w1 + d2 w2, d the differences of 8 bits at vertices 1 and 2, w their
 * weights. The steps of the weights, in 5.27 steps of red and blue for a difference of 1, are
 * products of a coordinate below 2^bits and the upper bits of a reciprocal, so that 32 bits hold
 * them. A channel then takes six products modulo 2^32. */
#include "../../core/draw/setup.h"
#include "../../core/fragment/gouraud.h"
#include "candidates.h"

struct weight {
    uint32_t origin, dx, dy;
};

static uint32_t scaled_wrap(int32_t v, int32_t s)
{
    return s >= 0 ? (uint32_t)v << s : (uint32_t)((v + (INT32_C(1) << (-s - 1))) >> -s);
}

/* dx and dy are set: the origin from vertex 0, where the weight is 0. */
static void anchor_wrap(struct weight *w, const struct etch_basis *b)
{
    const int32_t fine = ((int32_t)w->dx >> 8) * b->fx + ((int32_t)w->dy >> 8) * b->fy;

    w->origin = (uint32_t)fine - w->dx * (uint32_t)b->ax - w->dy * (uint32_t)b->ay;
}

/* 63 / 62 of it: from 5.27 of 31 steps to 6.26 of 63. */
static uint32_t finer_wrap(uint32_t v)
{
    return v + (uint32_t)((int32_t)v >> 6) + (uint32_t)((int32_t)v >> 11);
}

static void channel_wrap(struct etch_plane *p, const struct weight *w1, const struct weight *w2,
                         uint32_t c0, int32_t d1, int32_t d2)
{
    p->origin = c0 + w1->origin * (uint32_t)d1 + w2->origin * (uint32_t)d2;
    p->dx = w1->dx * (uint32_t)d1 + w2->dx * (uint32_t)d2;
    p->dy = w1->dy * (uint32_t)d1 + w2->dy * (uint32_t)d2;
}

static bool weights_wrap(struct weight *w1, struct weight *w2, const struct etch_basis *b)
{
    const int32_t s = b->shift + b->bits - 27;
    /* 31 / 255 of the reciprocal, 28 bits */
    const int32_t r = (b->reciprocal >> 3) - (b->reciprocal >> 8), k = (r + (r >> 8)) >> b->bits;

    if (3 * b->bits + b->shift > 49) /* off by 2^(2 bits + s + 2), to stay below 1/8 step or 2^24 */
        return false;
    w1->dx = scaled_wrap(b->y2 * k, s);
    w1->dy = scaled_wrap(-b->x2 * k, s);
    w2->dx = scaled_wrap(-b->y1 * k, s);
    w2->dy = scaled_wrap(b->x1 * k, s);
    anchor_wrap(w1, b);
    anchor_wrap(w2, b);
    return true;
}

static bool planes_wrap(struct etch_gouraud_paint *paint, const struct etch_triangle *t,
                        const struct etch_basis *b, const struct etch_vertex *const v[3])
{
    const struct etch_vertex *const v0 = v[t->order[0]], *const v1 = v[t->order[1]];
    const struct etch_vertex *const v2 = v[t->order[2]];
    struct weight w1, w2;

    if (!weights_wrap(&w1, &w2, b))
        return false;
    /* 1/8 step from the ends: 31 - 2/8 and 63 - 2/8 of 255 */
    channel_wrap(&paint->r, &w1, &w2, v0->r * UINT32_C(16185081) + (UINT32_C(5) << 24),
                 v1->r - v0->r, v2->r - v0->r);
    channel_wrap(&paint->b, &w1, &w2, v0->b * UINT32_C(16185081) + (UINT32_C(5) << 24),
                 v1->b - v0->b, v2->b - v0->b);
    w1.dx = finer_wrap(w1.dx), w1.dy = finer_wrap(w1.dy);
    w2.dx = finer_wrap(w2.dx), w2.dy = finer_wrap(w2.dy);
    anchor_wrap(&w1, b);
    anchor_wrap(&w2, b);
    channel_wrap(&paint->g, &w1, &w2, v0->g * UINT32_C(16514045) + (UINT32_C(5) << 23),
                 v1->g - v0->g, v2->g - v0->g);
    return true;
}

void candidate_triangle_fast(const struct etch_surface *s, const struct etch_vertex *const v[3],
                             etch_kernel *kernel)
{
    struct etch_gouraud_paint paint;
    struct etch_triangle t;
    struct etch_basis b;

    if (!setup_visible(&t, s, v))
        return;
    const struct etch_basis *const basis = etch_basis_setup(&b, &t) ? &b : NULL;

    paint.paint.kernel = kernel;
    if (basis == NULL || !planes_wrap(&paint, &t, basis, v))
        setup_color(&paint, &t, basis, v);
    etch_triangle_runs(s, &t, &paint.paint);
}
