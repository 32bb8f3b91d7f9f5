/* draw/varying_depth.c: depth linear on the screen. Named by pipelines, called by staged.c. See
 * staged.h. */
#include "setup.h"
#include "staged.h"

void etch_varying_depth(struct etch_staged_planes *planes, const struct etch_varying_input *in)
{
    setup_depth(&planes->z, in->triangle, in->basis, in->v);
}
