/* draw/line_wide.c: a line as two triangles. Called by applications and sinks. See line.h. */
#include "line.h"

void etch_line_wide(const struct etch_surface *s, const struct etch_vertex *const v[2],
                    uint16_t width_q8, etch_triangle_painter *painter, etch_kernel *kernel)
{
    struct etch_vertex c[4];

    if (!etch_line_wide_corners(c, v, width_q8))
        return;
    const struct etch_vertex *const first[3] = {&c[0], &c[1], &c[2]};
    const struct etch_vertex *const second[3] = {&c[0], &c[2], &c[3]};

    painter(s, first, kernel);
    painter(s, second, kernel);
}
