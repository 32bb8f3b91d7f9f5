/* frame/multisample_flat_lequal.c: triangles in one colour, with depth, on four samples a pixel.
 * Called by applications and by the sink. See multisample.h. */
#include "multisample.h"
#include "multisample_rows.h"

void etch_multisample_flat_lequal(const struct etch_multisample *m,
                                  const struct etch_vertex *const v[3])
{
    sample_paint(m->sample, v, sample_grid, false, etch_depth_lequal, false);
}
