/* raster/smooth_arc.c: smooth parts of rings and discs. Called by applications. See
 * smooth_shapes.h. */
#include "sector.h"
#include "smooth_ring.h"

struct part {
    struct etch_smooth_ring ring;
    struct etch_sector sector;
};

static void line(void *shape, int32_t y, struct etch_row *row)
{
    struct part *const p = shape;
    struct etch_ring_line at;

    if (!etch_smooth_ring_line(&p->ring, y, &at))
        return;
    etch_sector_move(&p->sector, p->ring.centre.x, y - p->ring.centre.y);
    etch_sector_add(&p->sector, row, at.x0, at.x1);
    etch_sector_add(&p->sector, row, at.x2, at.x3);
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

    const struct etch_smooth_lines lines = etch_smooth_ring_lines(&p.ring, &p, line);

    etch_sector_init(&p.sector, from, sweep, etch_smooth_lines_first(s, &lines) - centre.y, 16);
    etch_smooth_lines_fill(s, &lines, paint, cover);
}
