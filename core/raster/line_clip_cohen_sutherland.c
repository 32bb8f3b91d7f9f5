/* raster/line_clip_cohen_sutherland.c: lines cut by outcodes. Called by applications. See
 * line_clip.h. */
#include "line_clip.h"
#include "line_cut.h"

/* An end of the line: as it was, or where the whole line meets a side. */
struct end {
    bool is_cut;
    uint8_t axis;
    int32_t at;
};

struct line {
    int32_t p[2][2];      /* the whole line */
    int32_t lo[2], hi[2]; /* the bounds, axis by axis */
};

/* The end's coordinate on an axis less `bound`, as a sign, exactly. */
static int8_t compare(const struct line *l, const struct end *end, uint8_t i, uint8_t axis,
                      int32_t bound)
{
    const int32_t v = end->is_cut ? end->at : l->p[i][axis];

    if (end->is_cut && end->axis != axis)
        return etch_line_cut_compare(l->p[0], l->p[1], end->axis, end->at, bound);
    return (int8_t)((v > bound) - (v < bound));
}

/* Bit 2 axis: below the lower side; bit 2 axis + 1: above the upper one. */
static uint8_t outcode(const struct line *l, const struct end *end, uint8_t i)
{
    uint8_t out = 0;

    for (uint8_t axis = 0; axis < 2; axis++) {
        if (compare(l, end, i, axis, l->lo[axis]) < 0)
            out = (uint8_t)(out | 1 << 2 * axis);
        if (compare(l, end, i, axis, l->hi[axis]) > 0)
            out = (uint8_t)(out | 2 << 2 * axis);
    }
    return out;
}

/* Moves an end to the first side that its outcode names; the other end is on the inner side, so
 * the line crosses it. */
static void move(const struct line *l, struct end *end, uint8_t out)
{
    end->is_cut = true;
    end->axis = (out & 3) != 0 ? 0 : 1;
    end->at = (out >> 2 * end->axis & 1) != 0 ? l->lo[end->axis] : l->hi[end->axis];
}

static void resolve(const struct line *l, const struct end *end, struct etch_point_s32 *p)
{
    if (!end->is_cut)
        return;
    const int32_t other = etch_line_cut_round(l->p[0], l->p[1], end->axis, end->at);

    p->x = end->axis == 0 ? end->at : other;
    p->y = end->axis == 0 ? other : end->at;
}

bool etch_line_clip_cohen_sutherland(const struct etch_bounds *bounds, struct etch_point_s32 p[2])
{
    const struct line l = {
        {{p[0].x, p[0].y}, {p[1].x, p[1].y}}, {bounds->x0, bounds->y0}, {bounds->x1, bounds->y1}};
    struct end end[2] = {{false, 0, 0}, {false, 0, 0}};

    for (;;) {
        const uint8_t out0 = outcode(&l, &end[0], 0), out1 = outcode(&l, &end[1], 1);

        if ((out0 & out1) != 0)
            return false;
        if (out0 == 0 && out1 == 0)
            break;
        move(&l, out0 != 0 ? &end[0] : &end[1], out0 != 0 ? out0 : out1);
    }
    resolve(&l, &end[0], &p[0]);
    resolve(&l, &end[1], &p[1]);
    return true;
}
