/* draw/triangle_barycentric.c: triangles in the colours of a user's function. Called by
 * applications. See triangle.h. */
#include "../fragment/barycentric.h"
#include "setup.h"

void etch_triangle_barycentric(const struct etch_surface *s, const struct etch_vertex *const v[3],
                               etch_barycentric_function *color, void *context)
{
    static const uint32_t one_q31 = UINT32_C(1) << 31;
    struct etch_barycentric_paint paint = {
        {etch_kernel_barycentric}, {{0, 0, 0}, {0, 0, 0}}, {0, 0, 0}, color, context};
    struct etch_triangle t;

    if (!setup_visible(&t, s, v))
        return;
    for (uint8_t i = 0; i < 3; i++)
        paint.order[i] = t.order[i];
    for (uint8_t i = 0; i < 2; i++) {
        uint32_t weight[3] = {0, 0, 0};

        weight[t.order[i]] = one_q31;
        etch_plane_setup(&paint.b[i], &t, weight);
    }
    etch_triangle_runs(s, &t, &paint.paint);
}
