/* raster/circle.c: the midpoint circle, two octants at a time. Called by applications. See
 * circle.h, and octant.h for the derivation.
 *
 * The pixels right and left of the centre column lie in one row, so one decision serves both. The
 * octants whose rows are cy +- y(x) are called flat, those with cy +- x steep.
 */
#include "line.h"
#include "octant.h"

/* A circle to be cut, and on which side of its centre row. */
struct half {
    const struct etch_surface *surface;
    int32_t cx, cy, r;
    int32_t sign; /* 1 below, -1 above */
    uint16_t color;
};

/* The pen, and the pixels right and left. */
struct pens {
    uint16_t *p, *q;
    struct etch_octant_pen at;
};

/* Goes on to column `to` with both pixels, which are written: outwards in a flat octant, */
static void walk_flat(struct pens *pens, ptrdiff_t row, int32_t to, uint16_t color)
{
    const int32_t last = 2 * to - 1;
    int32_t right = pens->at.right, down = pens->at.down, d = pens->at.d;
    uint16_t *p = pens->p, *q = pens->q;

    while (right != last) {
        right += 2;
        p++, q--;
        d += right;
        if (d >= 0) {
            p -= row, q -= row;
            d -= down;
            down -= 2;
        }
        *p = color, *q = color;
    }
    *pens = (struct pens){p, q, {right, down, d}};
}

/* and from row to row in a steep one. Cortex-M0+ (W4): 5.4 instructions a pixel. */
static void walk_steep(const struct pens *pens, ptrdiff_t row, int32_t to, uint16_t color)
{
    const int32_t last = 2 * to - 1;
    int32_t right = pens->at.right, down = pens->at.down, d = pens->at.d;
    uint16_t *p = pens->p, *q = pens->q;

    while (right != last) {
        right += 2;
        p += row, q += row;
        d += right;
        if (d >= 0) {
            p--, q++;
            d -= down;
            down -= 2;
        }
        *p = color, *q = color;
    }
}

/* The pixel that is `right` columns and `down` rows from the centre, which must be in the clip. */
static uint16_t *pixel_at(const struct half *h, int32_t right, int32_t down)
{
    const struct etch_surface *const s = h->surface;

    return s->pixels +
           etch_surface_index(s, (int16_t)(h->cx + right), (int16_t)(h->cy + h->sign * down));
}

static ptrdiff_t row_step(const struct half *h)
{
    return h->sign > 0 ? (ptrdiff_t)h->surface->stride : -(ptrdiff_t)h->surface->stride;
}

/* The rows of the clip, from the centre on. */
static struct etch_octant_part clip_rows(const struct half *h)
{
    const struct etch_rect *const clip = &h->surface->clip;

    return h->sign > 0 ? (struct etch_octant_part){clip->y0 - h->cy, clip->y1 - 1 - h->cy}
                       : (struct etch_octant_part){h->cy - clip->y1 + 1, h->cy - clip->y0};
}

/* Where both sides are in sight so is the centre column: they begin together. */
static void flat(const struct half *h, struct etch_octant_part right)
{
    const struct etch_octant_part rows = clip_rows(h);
    const int32_t near = h->surface->clip.x0 - h->cx, far = h->surface->clip.x1 - 1 - h->cx;
    struct etch_octant_part left;
    struct pens pens;

    etch_octant_cut_y(&right, rows.from, rows.to, h->r);
    left = right;
    octant_cut_x(&right, near, far);
    octant_cut_x(&left, -far, -near);
    if (!octant_has(&right) && !octant_has(&left))
        return;

    const bool both = octant_has(&right) && octant_has(&left);
    bool leads = octant_has(&right); /* goes on where the other side ends */
    const int32_t x = leads ? right.from : left.from;
    const int32_t y = etch_octant_start(&pens.at, x, h->r);
    uint16_t *p = pixel_at(h, leads ? x : -x, y);

    *p = h->color;
    if (both) {
        pens.p = p;
        pens.q = p - 2 * x;
        if (x != 0)
            *pens.q = h->color;
        walk_flat(&pens, row_step(h), right.to < left.to ? right.to : left.to, h->color);
        if (right.to == left.to)
            return;
        leads = right.to > left.to;
        p = leads ? pens.p : pens.q;
    }
    etch_octant_walk(&pens.at, p, leads ? 1 : -1, row_step(h), leads ? right.to : left.to,
                     h->color);
}

/* Where both sides are in sight they end together: one may begin alone. */
static void steep(const struct half *h, struct etch_octant_part right)
{
    const struct etch_octant_part rows = clip_rows(h);
    const int32_t near = h->surface->clip.x0 - h->cx, far = h->surface->clip.x1 - 1 - h->cx;
    struct etch_octant_part left;
    struct pens pens;

    octant_cut_x(&right, rows.from, rows.to);
    left = right;
    etch_octant_cut_y(&right, near, far, h->r);
    etch_octant_cut_y(&left, -far, -near, h->r);
    if (!octant_has(&right) && !octant_has(&left))
        return;

    const bool both = octant_has(&right) && octant_has(&left);
    const bool leads = octant_has(&right) && (!both || right.from <= left.from);
    const struct etch_octant_part first = leads ? right : left, second = leads ? left : right;
    const int8_t side = leads ? 1 : -1;
    const int32_t y = etch_octant_start(&pens.at, first.from, h->r);
    uint16_t *p = pixel_at(h, side * y, first.from);

    *p = h->color;
    if (!both || first.from != second.from)
        p = etch_octant_walk(&pens.at, p, row_step(h), side, both ? second.from : first.to,
                             h->color);
    if (both) {
        const int32_t across = pens.at.down + 2; /* 2 y */
        uint16_t *const q = leads ? p - across : p + across;

        *q = h->color;
        pens.p = leads ? p : q;
        pens.q = leads ? q : p;
        walk_steep(&pens, row_step(h), right.to, h->color);
    }
}

static bool is_inside(const struct etch_rect *c, int16_t cx, int16_t cy, int16_t r)
{
    return cx - (int32_t)r >= c->x0 && cx + (int32_t)r < c->x1 && cy - (int32_t)r >= c->y0 &&
           cy + (int32_t)r < c->y1;
}

void etch_circle_draw(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t r,
                      uint16_t color)
{
    if (r <= 0) {
        if (r == 0)
            etch_point_draw(s, cx, cy, color);
        return;
    }

    const int32_t end = octant_end(r), steep_end = end - octant_meets_diagonal(r, end);

    if (is_inside(&s->clip, cx, cy, r)) {
        etch_circle_whole(s->pixels + etch_surface_index(s, cx, cy), (ptrdiff_t)s->stride, r, end,
                          steep_end, color);
    } else {
        const struct half below = {s, cx, cy, r, 1, color}, above = {s, cx, cy, r, -1, color};

        flat(&below, (struct etch_octant_part){0, end});
        flat(&above, (struct etch_octant_part){0, end});
        steep(&below, (struct etch_octant_part){0, steep_end});
        steep(&above, (struct etch_octant_part){1, steep_end}); /* the centre row is drawn */
    }
}
