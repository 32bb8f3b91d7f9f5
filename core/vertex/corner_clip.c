/* vertex/corner_clip.c: Sutherland-Hodgman against near, far and guard planes, in barycentric
 * coordinates. Called by clip.c and varying.c for the few triangles that cross a plane. See clip.h;
 * corner.c computes the new corners. */
#include "corner.h"

/* Distances of the triangle's vertices from plane i: near w + z, far w - z, then 2^guard w + x,
 * 2^guard w - x and the same with y. At most 2^41 + 2^31. */
static void set_plane(struct corner_line *line, const struct etch_viewport *viewport, int i,
                      const struct etch_clip_vertex v[3])
{
    const uint8_t shift = i < 2 ? 0 : i < 4 ? viewport->guard_x : viewport->guard_y;

    for (int j = 0; j < 3; j++) {
        const int64_t axis = i < 2 ? v[j].z : i < 4 ? v[j].x : v[j].y;

        line->at[j] = v[j].w * (INT64_C(1) << shift) + ((i & 1) != 0 ? -axis : axis);
    }
}

static void set_lines(struct corner_line lines[CORNER_LINES], const struct etch_viewport *viewport,
                      const struct etch_clip_vertex v[3])
{
    for (int i = 0; i < CORNER_EDGES; i++)
        for (int j = 0; j < 3; j++)
            lines[i].at[j] = i == j;
    for (int i = 0; i < CORNER_LINES - CORNER_EDGES; i++)
        set_plane(&lines[CORNER_EDGES + i], viewport, i, v);
}

/* The line from one corner to the next. */
static uint8_t common_line(const struct corner *a, const struct corner *b)
{
    return a->line[0] == b->line[0] || a->line[0] == b->line[1] ? a->line[0] : a->line[1];
}

/* to = the part of `from` inside the plane lines[plane]. False if that is all of it; then `to`
 * is not set. */
static bool clip_plane(const struct corner_line *lines, uint8_t plane,
                       const struct corner_polygon *from, struct corner_polygon *to)
{
    bool inside[ETCH_CLIP_MAX];
    bool all = true;

    for (uint8_t i = 0; i < from->n; i++) {
        inside[i] = etch_corner_is_inside(&from->corner[i], &lines[plane]);
        all = all && inside[i];
    }
    if (all)
        return false;
    to->n = 0;
    for (uint8_t i = 0; i < from->n; i++) {
        const uint8_t next = (uint8_t)(i + 1 < from->n ? i + 1 : 0);
        const struct corner *a = &from->corner[i];

        /* A convex polygon crosses a plane twice; if rounding made it more, leave them out. */
        if (inside[i] && to->n < ETCH_CLIP_MAX)
            to->corner[to->n++] = *a;
        if (inside[i] != inside[next] && to->n < ETCH_CLIP_MAX)
            etch_corner_meet(&to->corner[to->n++], lines, common_line(a, &from->corner[next]),
                             plane);
    }
    return true;
}

const struct corner_polygon *etch_corner_clip(struct corner_work *work,
                                              const struct etch_viewport *viewport,
                                              const struct etch_clip_vertex v[3])
{
    struct corner_polygon *now = &work->polygon[0], *then = &work->polygon[1];

    set_lines(work->lines, viewport, v);
    now->n = 3;
    for (uint8_t i = 0; i < 3; i++)
        etch_corner_vertex(&now->corner[i], i);
    for (uint8_t plane = CORNER_EDGES; plane < CORNER_LINES; plane++) {
        if (clip_plane(work->lines, plane, now, then)) {
            struct corner_polygon *const swap = now;

            now = then;
            then = swap;
        }
    }
    if (now->n < 3)
        now->n = 0;
    return now;
}
