/* vertex/clip.c: Sutherland-Hodgman against near, far and guard planes. Called by assembly for
 * the few triangles that cross one of them. See clip.h; cut.c makes the new vertices. */
#include "clip.h"
#include "cut.h"

enum { PLANES = 6 };

/* Signed distance of corner c from plane i, inside where >= 0; at most 2^42. The planes: near
 * z + w, far w - z, then x and y: 2^guard w + v and 2^guard w - v. */
static int64_t distance(const struct etch_viewport *viewport, int i, const struct cut_corner *c)
{
    const int axis = i < 2 ? 2 : i < 4 ? 0 : 1;
    const uint8_t shift = i < 2 ? 0 : i < 4 ? viewport->guard_x : viewport->guard_y;
    const int64_t scaled = c->v[3] * (INT64_C(1) << shift);

    return (i & 1) != 0 ? scaled - c->v[axis] : scaled + c->v[axis];
}

struct polygon {
    uint8_t n;
    struct cut_corner corner[ETCH_CLIP_MAX];
};

/* The corner where `plane` cuts the edge from `in` to `out`. On an edge of the triangle it is
 * computed from that edge's ends, unless rounding has put both on one side. */
static void cut(const struct etch_viewport *viewport, int plane,
                const struct cut_corner triangle[3], const struct cut_corner *in,
                const struct cut_corner *out, struct cut_corner *result)
{
    const uint8_t ends = in->ends | out->ends;

    if (ends != 7) {
        const struct cut_corner *a = &triangle[(ends & 1) != 0 ? 0 : 1];
        const struct cut_corner *b = &triangle[(ends & 4) != 0 ? 2 : 1];
        const bool a_inside = distance(viewport, plane, a) >= 0;

        if (a_inside != (distance(viewport, plane, b) >= 0)) {
            in = a_inside ? a : b;
            out = a_inside ? b : a;
        }
    }
    etch_cut_edge(result, in, distance(viewport, plane, in), out,
                  distance(viewport, plane, out));
}

/* to = the part of from inside the plane. Returns false if to is not set: all is inside. */
static bool clip_plane(const struct etch_viewport *viewport, int plane,
                       const struct cut_corner triangle[3], const struct polygon *from,
                       struct polygon *to)
{
    bool inside[ETCH_CLIP_MAX];
    bool all = true;

    for (int i = 0; i < from->n; i++) {
        inside[i] = distance(viewport, plane, &from->corner[i]) >= 0;
        all = all && inside[i];
    }
    if (all)
        return false;
    to->n = 0;
    for (int i = 0; i < from->n; i++) {
        const int next = i + 1 < from->n ? i + 1 : 0;
        const struct cut_corner *a = &from->corner[i], *b = &from->corner[next];

        /* A convex polygon crosses a plane twice at most; rounding could make it more. */
        if (inside[i] && to->n < ETCH_CLIP_MAX)
            to->corner[to->n++] = *a;
        if (inside[i] != inside[next] && to->n < ETCH_CLIP_MAX)
            cut(viewport, plane, triangle, inside[i] ? a : b, inside[i] ? b : a,
                &to->corner[to->n++]);
    }
    return true;
}

uint8_t etch_clip_triangle(const struct etch_viewport *viewport,
                           const struct etch_clip_vertex v[3],
                           struct etch_clip_vertex out[ETCH_CLIP_MAX])
{
    struct polygon buffer[2];
    struct cut_corner triangle[3];
    int now = 0;

    buffer[0].n = 3;
    for (int i = 0; i < 3; i++) {
        etch_cut_corner(&triangle[i], &v[i], (uint8_t)(1 << i));
        buffer[0].corner[i] = triangle[i];
    }
    for (int plane = 0; plane < PLANES; plane++)
        if (clip_plane(viewport, plane, triangle, &buffer[now], &buffer[1 - now]))
            now = 1 - now;

    const struct polygon *polygon = &buffer[now];
    for (int i = 0; i < polygon->n; i++) {
        etch_cut_vertex(&out[i], &polygon->corner[i]);
        if (out[i].w <= 0) /* the eye itself: the triangle is seen edge-on */
            return 0;
    }
    return polygon->n < 3 ? 0 : polygon->n;
}
