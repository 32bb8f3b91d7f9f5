/* fragment/gradient_radial.c: rows of radial gradients. A brush; see gradient.h.
 *
 * At the squared distance D, with N = 2^bits, the entry is the largest i with i^2 r^2 <= N^2 D. It
 * is kept with f = N^2 D - i^2 r^2, and i = N stands for all that is outside. Where |dx| and |dy|
 * are at most r, D < 2^31 and f < 2^47. */
#include "gradient.h"

struct walk {
    int64_t f, grows; /* by from one pixel to the next */
    int32_t i, most;
    int64_t square; /* of the radius */
};

/* The entry is never too large at first: i r <= N floor(sqrt D). */
static void settle(struct walk *w)
{
    while (w->i < w->most && w->f >= w->square * (2 * w->i + 1)) {
        w->f -= w->square * (2 * w->i + 1);
        w->i++;
    }
    while (w->f < 0) {
        w->i--;
        w->f += w->square * (2 * w->i + 1);
    }
}

static void place(struct walk *w, const struct etch_gradient_radial *g, int32_t dx, int32_t dy)
{
    const uint8_t twice = (uint8_t)(2 * g->ramp->bits);
    const uint32_t r = (uint32_t)g->r, d = (uint32_t)(dx * dx) + (uint32_t)(dy * dy);

    w->most = INT32_C(1) << g->ramp->bits;
    w->square = r * r;
    w->i = d >= r * r ? w->most : (int32_t)(((uint32_t)etch_sqrt_u32(d) << g->ramp->bits) / r);
    w->f = ((int64_t)d << twice) - w->square * (w->i * w->i);
    w->grows = (2 * (int64_t)dx + 1) * (INT32_C(1) << twice);
    settle(w);
}

/* Pixels whose columns are within r of the centre, until `end` or beyond that. */
static uint16_t *inside(const struct etch_gradient_radial *g, int32_t dx, int32_t dy,
                        uint16_t *color, const uint16_t *end)
{
    const int64_t more = INT64_C(2) << (2 * g->ramp->bits);
    struct walk w;

    place(&w, g, dx, dy);
    for (; color != end && dx <= g->r; dx++) {
        *color++ = g->ramp->color[w.i < w.most ? w.i : w.most - 1];
        w.f += w.grows;
        w.grows += more;
        settle(&w);
    }
    return color;
}

static void colors(const struct etch_brush *brush, int16_t x, int16_t y, uint16_t n,
                   uint16_t *color)
{
    const struct etch_gradient_radial *const g = (const struct etch_gradient_radial *)brush;
    const uint16_t last = g->ramp->color[(1 << g->ramp->bits) - 1], *const end = color + n;
    const int32_t dy = (int32_t)y - g->cy;
    int32_t dx = (int32_t)x - g->cx;

    if (dy >= -(int32_t)g->r && dy <= g->r) {
        for (; color != end && dx < -(int32_t)g->r; dx++)
            *color++ = last;
        if (color != end && dx <= g->r)
            color = inside(g, dx, dy, color, end);
    }
    while (color != end)
        *color++ = last;
}

enum etch_status etch_gradient_radial_init(struct etch_gradient_radial *g,
                                           const struct etch_ramp *ramp, int16_t cx, int16_t cy,
                                           int16_t r)
{
    if (r < 1)
        return ETCH_EINVAL;
    g->brush.colors = colors;
    g->ramp = ramp;
    g->cx = cx;
    g->cy = cy;
    g->r = r;
    return ETCH_OK;
}
