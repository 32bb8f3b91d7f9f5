/* vertex/clip.c: a clipped triangle as vertices. Called by applications. See clip.h; corner_clip.c
 * finds the corners. */
#include "clip.h"
#include "corner.h"

uint8_t etch_clip_triangle(const struct etch_viewport *viewport, const struct etch_clip_vertex v[3],
                           struct etch_clip_vertex out[ETCH_CLIP_MAX])
{
    const struct corner_triangle t = {{&v[0], &v[1], &v[2]}, viewport->guard_x, viewport->guard_y};
    struct corner corner[ETCH_CLIP_MAX];
    const uint8_t n = etch_corner_clip(&t, corner);

    for (uint8_t i = 0; i < n; i++) {
        etch_corner_take(&out[i], &t, &corner[i]);
        if (out[i].w <= 0) /* the eye itself: the triangle is seen edge-on */
            return 0;
    }
    return n;
}
