/* vertex/viewport.c: viewport set-up and outcodes. Called by the application, by the mesh's
 * vertex loop and by assembly. See viewport.h; project.c has the projection. */
#include "viewport.h"

/* The largest shift for which the guard plane stays a pixel inside the range of positions, that
 * is 2^shift * size + |2 * centre| <= 65534 in half pixels. 0 always fits: an edge is an
 * int16_t. 10 bounds the loss of precision at a guard plane (clip.h). */
static uint8_t guard(int32_t from, int32_t to)
{
    const int32_t size = to - from;
    const int32_t centre = from + to < 0 ? -(from + to) : from + to;
    uint8_t shift = 0;

    while (shift < 10 && (size << (shift + 1)) + centre <= 65534)
        shift++;
    return shift;
}

enum etch_status etch_viewport_init(struct etch_viewport *v, struct etch_rect rect)
{
    if (etch_rect_is_empty(rect))
        return ETCH_EINVAL;
    v->rect = rect;
    v->guard_x = guard(rect.x0, rect.x1);
    v->guard_y = guard(rect.y0, rect.y1);
    return ETCH_OK;
}

/* |v| > w * 2^shift, without overflow: |v| - 1 is v - 1 or ~v. */
static bool beyond(etch_q16 v, etch_q16 w, uint8_t shift)
{
    return ((v > 0 ? v - 1 : ~v) >> shift) >= w;
}

uint8_t etch_viewport_outcode(const struct etch_viewport *v, const struct etch_clip_vertex *in)
{
    const etch_q16 x = in->x, y = in->y, z = in->z, w = in->w;
    uint8_t out = 0;

    /* v < -w is ~v >= w. */
    if (~x >= w)
        out |= ETCH_OUT_LEFT;
    if (x > w)
        out |= ETCH_OUT_RIGHT;
    if (~y >= w)
        out |= ETCH_OUT_BOTTOM;
    if (y > w)
        out |= ETCH_OUT_TOP;
    if (~z >= w)
        out |= ETCH_OUT_NEAR;
    if (z > w)
        out |= ETCH_OUT_FAR;
    if (out != 0 && (beyond(x, w, v->guard_x) || beyond(y, w, v->guard_y)))
        out |= ETCH_OUT_GUARD;
    if (out == 0 && w == 0) /* then x = y = z = 0 */
        out = ETCH_OUT_NEAR;
    return out;
}
