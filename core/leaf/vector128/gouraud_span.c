/* leaf/vector128/gouraud_span.c: etch_gouraud_span by vectors, in place of
 * fragment/gouraud_span.c. Called by the kernels with depth. */
#include "../../fragment/gouraud_span.h"
#include "gouraud_pixels.h"

void etch_gouraud_span(uint16_t *pixel, int32_t x, uint32_t n, int32_t y,
                       const struct etch_paint *paint)
{
    const struct etch_gouraud_paint *const p = (const struct etch_gouraud_paint *)paint;
    const struct gouraud_vector by4 = gouraud_steps(p);
    const struct gouraud_vector c = {
        vector_ramp(etch_plane_at(&p->r, (int16_t)x, (int16_t)y), p->r.dx),
        vector_ramp(etch_plane_at(&p->g, (int16_t)x, (int16_t)y), p->g.dx),
        vector_ramp(etch_plane_at(&p->b, (int16_t)x, (int16_t)y), p->b.dx)};

    gouraud_walk(pixel, n, c, &by4, gouraud_plain);
}
