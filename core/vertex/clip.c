/* vertex/clip.c: a clipped triangle as vertices. Called by assembly for the few triangles that cross
 * a plane. See clip.h; corner_clip.c finds the corners. */
#include "clip.h"
#include "corner.h"

uint8_t etch_clip_triangle(const struct etch_viewport *viewport, const struct etch_clip_vertex v[3],
                           struct etch_clip_vertex out[ETCH_CLIP_MAX])
{
    struct corner_work work;
    const struct corner_polygon *const polygon = etch_corner_clip(&work, viewport, v);

    for (uint8_t i = 0; i < polygon->n; i++) {
        const struct corner *const corner = &polygon->corner[i];
        const int8_t which = etch_corner_which(corner);

        if (which >= 0)
            out[i] = v[which];
        else
            etch_corner_resolve(&out[i], corner, v);
        if (out[i].w <= 0) /* the eye itself: the triangle is seen edge-on */
            return 0;
    }
    return polygon->n;
}
