/* raster/ellipse.c: ellipses to runs. Called by draw/ and applications. See ellipse.h. */
#include "ellipse.h"
#include "stretched.h"

static bool set(struct etch_stretched *p, const struct etch_surface *s, int16_t cx, int16_t cy,
                int16_t rx, int16_t ry)
{
    p->x0 = p->x1 = cx;
    p->y0 = p->y1 = cy;
    return etch_stretched_init(p, s, rx, ry);
}

void etch_ellipse_runs(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t rx, int16_t ry,
                       const struct etch_paint *paint)
{
    struct etch_stretched p;

    if (set(&p, s, cx, cy, rx, ry))
        etch_stretched_fill(s, &p, paint);
}

void etch_ellipse_outline_runs(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t rx,
                               int16_t ry, const struct etch_paint *paint)
{
    struct etch_stretched p;

    if (set(&p, s, cx, cy, rx, ry))
        etch_stretched_outline(s, &p, paint);
}
