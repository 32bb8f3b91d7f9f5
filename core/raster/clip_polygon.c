/* raster/clip_polygon.c: Sutherland-Hodgman as a pipeline. Called by applications. See
 * clip_polygon.h.
 *
 * Between two vertices the outline runs along an edge of the polygon or along a side that cut it
 * before, and each vertex knows which. So a plane cuts the whole edge, not what the planes before
 * left of it, and where a side meets a side is a corner of the rectangle. */
#include "clip_polygon.h"
#include "line_cut.h"

enum {
    PLANES = 4
};

struct vertex {
    int32_t p[2];       /* rounded where it is a cut */
    bool is_cut;        /* it is where the edge a b meets `axis coordinate = p[axis]` */
    bool along_side;    /* the way from the vertex before is a side, else the edge a b */
    uint8_t axis;       /* of the cut */
    uint8_t side_axis;  /* of the side: its coordinate there */
    int32_t side_at;    /* and that */
    int32_t a[2], b[2]; /* the edge */
};

static bool is_inside(const struct etch_clip_plane *plane, const struct vertex *v)
{
    const int32_t c = v->p[plane->axis], at = plane->at;
    const int8_t side = v->is_cut && v->axis != plane->axis
                            ? etch_line_cut_compare(v->a, v->b, v->axis, v->p[v->axis], at)
                            : (int8_t)((c > at) - (c < at));

    return plane->upper ? side <= 0 : side >= 0;
}

/* From now on the way to v is this plane's side. */
static void go_along(struct vertex *v, const struct etch_clip_plane *plane)
{
    v->along_side = true;
    v->side_axis = plane->axis;
    v->side_at = plane->at;
}

/* Where the way to v meets the plane. From outside, the outline has come along the plane's side. */
static struct vertex cut(const struct etch_clip_plane *plane, const struct vertex *v, bool enters)
{
    const uint8_t axis = plane->axis;
    struct vertex c = *v;

    c.is_cut = !v->along_side;
    c.axis = axis;
    c.p[axis ^ 1] = v->along_side ? v->side_at : etch_line_cut_round(v->a, v->b, axis, plane->at);
    c.p[axis] = plane->at;
    if (enters)
        go_along(&c, plane);
    return c;
}

/* One vertex through one plane: 0 to 2 of them, in order. */
static uint8_t pass(struct etch_clip_plane *plane, const struct vertex *v, struct vertex out[2])
{
    const bool inside = is_inside(plane, v);
    uint8_t n = 0;

    if (!plane->any)
        plane->first_inside = inside;
    else if (inside != plane->last_inside)
        out[n++] = cut(plane, v, inside);
    if (inside)
        out[n++] = *v;
    plane->any = true;
    plane->last_inside = inside;
    return n;
}

/* Hands a vertex on to plane `first` and what comes of it to the others. Of two vertices that a
 * plane lets through the second waits: at most one for each plane. */
static void hand_on(struct etch_clip_polygon *clip, uint8_t first, const struct vertex *v)
{
    struct vertex waiting[PLANES + 1];
    uint8_t to[PLANES + 1], n = 1;

    waiting[0] = *v;
    to[0] = first;
    while (n != 0) {
        const uint8_t plane = to[--n];
        struct vertex out[2];

        if (plane == PLANES) {
            const struct etch_point_s32 p = {waiting[n].p[0], waiting[n].p[1]};

            clip->function(clip->context, p);
            continue;
        }
        for (uint8_t k = pass(&clip->plane[plane], &waiting[n], out); k != 0; n++) {
            waiting[n] = out[--k];
            to[n] = (uint8_t)(plane + 1);
        }
    }
}

static struct vertex vertex(struct etch_point_s32 from, struct etch_point_s32 to)
{
    const struct vertex v = {{to.x, to.y}, false, false, 0, 0, 0, {from.x, from.y}, {to.x, to.y}};

    return v;
}

void etch_clip_polygon_begin(struct etch_clip_polygon *clip, const struct etch_bounds *bounds,
                             etch_polygon_vertex_function *function, void *context)
{
    const int32_t at[PLANES] = {bounds->x0, bounds->x1, bounds->y0, bounds->y1};

    clip->any = false;
    clip->function = function;
    clip->context = context;
    for (uint8_t i = 0; i < PLANES; i++) {
        clip->plane[i].axis = i >> 1;
        clip->plane[i].upper = (i & 1) != 0;
        clip->plane[i].any = false;
        clip->plane[i].at = at[i];
    }
}

void etch_clip_polygon_vertex(struct etch_clip_polygon *clip, struct etch_point_s32 p)
{
    const struct vertex v = vertex(clip->any ? clip->last : p, p);

    if (!clip->any)
        clip->first = p;
    clip->any = true;
    clip->last = p;
    hand_on(clip, 0, &v);
}

/* Plane after plane cuts the way back to its first vertex, if that changes sides. Where the first
 * vertex was outside, what follows the plane began with a cut, and ends along the plane's side. */
void etch_clip_polygon_end(struct etch_clip_polygon *clip)
{
    struct vertex back;

    if (!clip->any)
        return;
    back = vertex(clip->last, clip->first);
    for (uint8_t i = 0; i < PLANES; i++) {
        struct etch_clip_plane *const plane = &clip->plane[i];

        if (plane->any && plane->first_inside != plane->last_inside) {
            const struct vertex c = cut(plane, &back, plane->first_inside);

            hand_on(clip, (uint8_t)(i + 1), &c);
        }
        if (plane->any && !plane->first_inside)
            go_along(&back, plane);
        plane->any = false;
    }
    clip->any = false;
}
