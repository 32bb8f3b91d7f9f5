/* draw/line_varying_flat.c: the colour of a line's vertex 0. Named by pipelines, called by
 * line_staged.c. See line_staged.h. */
#include "line_staged.h"

void etch_line_varying_flat(struct etch_staged_planes *planes,
                            const struct etch_line_varying_input *in)
{
    const struct etch_varying_input first = {NULL, NULL, in->v};

    etch_varying_flat(planes, &first); /* reads v[0] alone */
}
