/* draw/varying_alpha.c: alpha linear on the screen. Named by pipelines, called by staged.c. See
 * staged.h. */
#include "../raster/texture_plane.h"
#include "staged.h"

void etch_varying_alpha(struct etch_staged_planes *planes, const struct etch_varying_input *in)
{
    uint32_t value[3];

    for (uint8_t i = 0; i < 3; i++) /* 8.23 + 1/128: room below 0 and above 255 for errors */
        value[i] = ((uint32_t)in->v[i]->a << 23) + (UINT32_C(1) << 16);
    etch_texture_plane(&planes->color.linear.a, in->triangle, in->basis, value);
}
