/* frame/shared_gouraud_less.c: triangles in interpolated colours, with depth, on samples that
 * neighbours share. Called by applications and by the sink. See shared.h. */
#include "shared.h"
#include "multisample_rows.h"

void etch_shared_gouraud_less(const struct etch_shared_samples *m,
                              const struct etch_vertex *const v[3])
{
    sample_paint(m->sample, v, sample_pairs, true, etch_depth_less, true);
}
