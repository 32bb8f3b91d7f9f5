/* draw/line_gouraud.c: lines with interpolated colour. Called by applications and sinks. See
 * line.h. */
#include "line_setup.h"

void etch_line_gouraud(const struct etch_surface *s, const struct etch_vertex *const v[2],
                       etch_kernel *kernel)
{
    struct etch_gouraud_paint paint;
    struct line_setup l;

    if (!line_setup(&l, s, v))
        return;
    paint.paint.kernel = kernel;
    line_color(&paint, &l, v);
    etch_line_steps_runs(s, &l.steps, &paint.paint);
}
