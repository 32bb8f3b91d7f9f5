/* frame/multisample_color.c: colour planes at the samples of a triangle and at its centre. Called
 * by the painters of samples. See multisample_setup.h. */
#include "../draw/setup.h"
#include "multisample_setup.h"

void etch_sample_color(const struct sample_shape *shape, const struct etch_vertex *const v[3],
                       struct etch_gouraud_paint *paint)
{
    for (uint8_t k = 0; k < shape->points; k++) {
        struct etch_basis b;

        setup_color(&paint[k], &shape->at[k], etch_basis_setup(&b, &shape->at[k]) ? &b : NULL, v);
    }
}
