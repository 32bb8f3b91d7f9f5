/* raster/texture_small.c: perspective from exact planes. Called by draw/. See texture_small.h. */
#include "texture_small.h"
#include "texture_values.h"

static void axis(struct etch_perspective_axis *a, const struct etch_point_q8 p[3],
                 const etch_q16 c[3], const int32_t q[3])
{
    uint32_t value[3];

    etch_texture_numerators(a, value, c, q);
    etch_plane_setup_small(&a->numerator, p, value);
    a->numerator.origin = etch_wrap_sub(a->numerator.origin, UINT32_C(1) << 29);
}

void etch_texture_perspective_small(struct etch_perspective_planes *planes,
                                    const struct etch_point_q8 p[3],
                                    const struct etch_texture_vertex *const vertex[3])
{
    const etch_q16 us[3] = {vertex[0]->u, vertex[1]->u, vertex[2]->u};
    const etch_q16 vs[3] = {vertex[0]->v, vertex[1]->v, vertex[2]->v};
    int32_t q[3];

    planes->least = etch_texture_inverses(q, vertex);
    planes->blocks = false;
    axis(&planes->u, p, us, q);
    axis(&planes->v, p, vs, q);
    const uint32_t inverse[3] = {(uint32_t)q[0], (uint32_t)q[1], (uint32_t)q[2]};

    etch_plane_setup_small(&planes->denominator, p, inverse);
}
