/* draw/varying_texture_perspective.c: texture coordinates in perspective. Named by pipelines,
 * called by staged.c. See staged.h. */
#include "../raster/texture_plane.h"
#include "staged.h"

void etch_varying_texture_perspective(struct etch_staged_planes *planes,
                                      const struct etch_varying_input *in)
{
    const struct etch_texture_vertex *v[3];

    for (uint8_t i = 0; i < 3; i++)
        v[i] = (const struct etch_texture_vertex *)in->v[i];
    (void)etch_texture_perspective(&planes->texture.perspective, in->triangle, in->basis, v);
}
