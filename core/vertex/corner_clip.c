/* vertex/corner_clip.c: Sutherland-Hodgman against near, far and guard planes, in barycentric
 * coordinates. Called by clip.c, assembly.c and varying.c for the few triangles that cross a plane.
 * See clip.h; corner_plane.c computes the new corners. */
#include "corner.h"

/* The line from one corner to the next. */
static uint8_t common_line(const struct corner *a, const struct corner *b)
{
    return a->line[0] == b->line[0] || a->line[0] == b->line[1] ? a->line[0] : a->line[1];
}

/* Leaves of corner[0 .. n-1] the part inside a plane and returns its number of corners. A plane
 * with all three vertices inside has all corners inside: they are weighted means. */
static uint8_t clip_plane(const struct corner_triangle *t, uint8_t plane, struct corner *corner,
                          uint8_t n)
{
    struct corner from[ETCH_CLIP_MAX];
    bool inside[ETCH_CLIP_MAX];
    struct corner_line line;
    uint8_t count = 0;

    etch_corner_line(&line, t, plane);
    if (line.at[0] >= 0 && line.at[1] >= 0 && line.at[2] >= 0)
        return n;
    for (uint8_t i = 0; i < n; i++) {
        from[i] = corner[i];
        inside[i] = etch_corner_is_in_plane(t, &from[i], &line);
    }
    for (uint8_t i = 0; i < n; i++) {
        const uint8_t next = (uint8_t)(i + 1 < n ? i + 1 : 0);

        /* A convex polygon crosses a plane twice; if rounding made it more, leave them out. */
        if (inside[i] && count < ETCH_CLIP_MAX)
            corner[count++] = from[i];
        if (inside[i] != inside[next] && count < ETCH_CLIP_MAX)
            corner[count++] = (struct corner){{common_line(&from[i], &from[next]), plane}};
    }
    return count;
}

uint8_t etch_corner_clip(const struct corner_triangle *t, struct corner corner[ETCH_CLIP_MAX])
{
    uint8_t n = 3;

    for (uint8_t i = 0; i < 3; i++)
        corner[i] = etch_corner_vertex(i);
    for (uint8_t plane = CORNER_EDGES; plane < CORNER_LINES; plane++)
        n = clip_plane(t, plane, corner, n);
    return n < 3 ? 0 : n;
}
