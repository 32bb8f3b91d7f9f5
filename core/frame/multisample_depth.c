/* frame/multisample_depth.c: depth planes at the samples of a triangle. Called by the painters of
 * samples with depth. See multisample_setup.h. */
#include "../draw/setup.h"
#include "multisample_setup.h"

void etch_sample_depth(const struct sample_shape *shape, const struct etch_vertex *const v[3],
                       struct etch_gouraud_paint *paint)
{
    for (uint8_t k = 0; k < ETCH_SAMPLES; k++) {
        struct etch_basis b;

        setup_depth(&paint[k].z, &shape->at[k], etch_basis_setup(&b, &shape->at[k]) ? &b : NULL, v);
    }
}
