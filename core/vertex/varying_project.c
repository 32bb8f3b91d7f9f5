/* vertex/varying_project.c: one vertex with varyings to the screen. Called by varying.c and by
 * draw/mesh_varying. See varying.h. */
#include "varying.h"

void etch_varying_project(const struct etch_viewport *viewport, const struct etch_clip_vertex *in,
                          uint8_t count, struct etch_vertex *out)
{
    const int32_t *const from = (const int32_t *)(const void *)(in + 1);
    int32_t *const to = (int32_t *)(void *)(out + 1);

    etch_viewport_project(viewport, in, out);
    to[0] = from[0];
    to[1] = from[1];
    to[2] = in->w; /* > 0, so it is the same as an uint32_t */
    for (uint8_t i = 2; i < count; i++)
        to[i + 1] = from[i];
}
