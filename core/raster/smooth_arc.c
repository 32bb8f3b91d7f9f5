/* raster/smooth_arc.c: smooth parts of rings and discs. Called by applications. See smooth_shapes.h. */
#include "sector.h"
#include "smooth_ring.h"

struct part {
    struct etch_smooth_ring ring;
    struct etch_sector sector;
};

static void line(void *shape, int32_t y, struct etch_row *row)
{
    struct part *const p = shape;
    const int32_t x = p->ring.centre.x, b = y - p->ring.centre.y;
    struct etch_ring_line at;

    if (!etch_smooth_ring_line(&p->ring, y, &at))
        return;
    etch_sector_add(&p->sector, row, x, b, at.x0, at.x1);
    etch_sector_add(&p->sector, row, x, b, at.x2, at.x3);
}

void etch_smooth_arc(const struct etch_surface *s, struct etch_point_q8 centre, int32_t outer,
                     int32_t inner, uint16_t from, uint32_t sweep,
                     const struct etch_cover_paint *paint, int16_t *cover)
{
    struct part p;

    if (outer <= 0 || inner >= outer || sweep == 0)
        return;
    p.ring.centre = centre;
    p.ring.outer = outer;
    p.ring.inner = inner;
    etch_sector_init(&p.sector, from, sweep, 16);

    const struct etch_smooth_lines lines = etch_smooth_ring_lines(&p.ring, &p, line);

    etch_smooth_lines_fill(s, &lines, paint, cover);
}
