/* draw/varying_alpha.c: alpha linear on the screen. Named by pipelines, called by staged.c. See
 * staged.h. */
#include "../raster/alpha_plane.h"
#include "staged.h"

void etch_varying_alpha(struct etch_staged_planes *planes, const struct etch_varying_input *in)
{
    etch_alpha_plane(&planes->color.linear.a, in->triangle, in->basis, in->v);
}
