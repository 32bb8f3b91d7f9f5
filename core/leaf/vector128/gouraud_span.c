/* leaf/vector128/gouraud_span.c: etch_gouraud_span by vectors, in place of
 * fragment/gouraud_span.c. Called by the kernels with depth. */
#include "../../fragment/gouraud_span.h"
#include "gouraud_pixels.h"

void etch_gouraud_span(uint16_t *pixel, int32_t x, uint32_t n, int32_t y,
                       const struct etch_paint *paint)
{
    const struct gouraud_planes planes = gouraud_planes((const struct etch_gouraud_paint *)paint,
                                                        (int16_t)y);
    const struct gouraud_vector ramp = gouraud_ramp(planes.dx);
    const struct gouraud_vector by4 = gouraud_spread(planes.dx << 2);
    struct gouraud_vector c = gouraud_spread(gouraud_planes_at(&planes, (uint32_t)x));

    gouraud_step(&c, &ramp);
    gouraud_walk(pixel, n, c, &by4, gouraud_plain);
}
