/* draw/varying_color.c: colours linear on the screen. Named by pipelines, called by staged.c. See
 * staged.h. */
#include "staged.h"

void etch_varying_color(struct etch_staged_planes *planes, const struct etch_varying_input *in)
{
    struct etch_plane *const r = &planes->color.linear.r, *const g = &planes->color.linear.g;
    struct etch_plane *const b = &planes->color.linear.b;

    if (in->basis == NULL || !etch_basis_color(in->basis, in->triangle, in->v, r, g, b))
        etch_plane_color(in->triangle, in->v, r, g, b);
}
