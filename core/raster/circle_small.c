/* raster/circle_small.c: midpoint circles, octant by octant, in few bytes. Called by applications. See
 * circle_small.h, and octant.h for the derivation. */
#include "circle_small.h"
#include "line.h"
#include "octant.h"

/* One image of the octant: pixel (x, y) goes to (cx + sx x, cy + sy y), or if `swapped` to
 * (cx + sx y, cy + sy x). */
struct octant {
    int8_t sx, sy;
    bool swapped;
    struct etch_octant_part part;
};

/* The part lo .. hi of the axis that grows by `sign` from `centre`. */
static void mirror(int8_t sign, int32_t centre, int32_t *lo, int32_t *hi)
{
    const int32_t first = sign > 0 ? *lo - centre : centre - *hi;
    const int32_t last = sign > 0 ? *hi - centre : centre - *lo;

    *lo = first;
    *hi = last;
}

/* Cuts an octant to the clip. */
static void octant_clip(struct octant *o, struct etch_rect clip, int16_t cx, int16_t cy, int32_t r)
{
    int32_t x_lo = o->swapped ? clip.y0 : clip.x0, x_hi = (o->swapped ? clip.y1 : clip.x1) - 1;
    int32_t y_lo = o->swapped ? clip.x0 : clip.y0, y_hi = (o->swapped ? clip.x1 : clip.y1) - 1;

    mirror(o->swapped ? o->sy : o->sx, o->swapped ? cy : cx, &x_lo, &x_hi);
    mirror(o->swapped ? o->sx : o->sy, o->swapped ? cx : cy, &y_lo, &y_hi);
    etch_octant_cut_y(&o->part, y_lo, y_hi, r);
    octant_cut_x(&o->part, x_lo, x_hi);
}

static void octant_draw(const struct octant *o, const struct etch_surface *s, int16_t cx,
                        int16_t cy, int32_t r, uint16_t color)
{
    struct etch_octant_pen pen;
    const int32_t x = o->part.from, y = etch_octant_start(&pen, x, r);
    const int16_t px = (int16_t)(cx + o->sx * (o->swapped ? y : x));
    const int16_t py = (int16_t)(cy + o->sy * (o->swapped ? x : y));
    const ptrdiff_t row = o->sy > 0 ? (ptrdiff_t)s->stride : -(ptrdiff_t)s->stride;
    const ptrdiff_t along = o->swapped ? row : o->sx, across = o->swapped ? o->sx : row;
    uint16_t *const p = s->pixels + etch_surface_index(s, px, py);

    *p = color;
    etch_octant_walk(&pen, p, along, across, o->part.to, color);
}

void etch_circle_draw_small(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t r,
                            uint16_t color)
{
    if (r <= 0) {
        if (r == 0)
            etch_point_draw(s, cx, cy, color);
        return;
    }

    const int32_t end = octant_end(r);
    const bool diagonal = octant_meets_diagonal(r, end);

    for (uint8_t i = 0; i < 8; i++) {
        struct octant o = {
            (int8_t)((i & 1) ? -1 : 1), (int8_t)((i & 2) ? -1 : 1), (i & 4) != 0, {0, end}};

        if ((o.swapped ? o.sy : o.sx) < 0)
            o.part.from = 1; /* x = 0 belongs to the other sign */
        if (o.swapped && diagonal)
            o.part.to = end - 1;
        octant_clip(&o, s->clip, cx, cy, r);
        if (octant_has(&o.part))
            octant_draw(&o, s, cx, cy, r, color);
    }
}
