/* draw/line_flat_depth.c: lines in the colour of their first vertex, with depth. Called by
 * applications and sinks. See line.h. */
#include "../base/rgb565.h"
#include "../fragment/flat.h"
#include "line_setup.h"

static void flat_depth(const struct etch_surface *s, const struct etch_vertex *const v[2],
                       etch_kernel *kernel, uint16_t color)
{
    struct etch_flat_depth_paint paint;
    struct line_setup l;

    if (!line_setup(&l, s, v))
        return;
    paint.paint.kernel = kernel;
    paint.color = color;
    line_depth(&paint.z, &l, v);
    etch_line_steps_runs(s, &l.steps, &paint.paint);
}

void etch_line_flat_depth(const struct etch_surface *s, const struct etch_vertex *const v[2],
                          etch_kernel *kernel)
{
    flat_depth(s, v, kernel, etch_rgb565(v[0]->r, v[0]->g, v[0]->b));
}

void etch_line_flat_depth_swapped(const struct etch_surface *s,
                                  const struct etch_vertex *const v[2], etch_kernel *kernel)
{
    flat_depth(s, v, kernel, etch_rgb565_swap(etch_rgb565(v[0]->r, v[0]->g, v[0]->b)));
}
