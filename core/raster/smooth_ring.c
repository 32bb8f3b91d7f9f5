/* raster/smooth_ring.c: smooth discs, circles and rings. Called by applications. See
 * smooth_shapes.h. */
#include "smooth_ring.h"

static void line(void *shape, int32_t y, struct etch_row *row)
{
    struct etch_ring_line at;

    if (!etch_smooth_ring_line(shape, y, &at))
        return;
    etch_row_add(row, at.x0, at.x1);
    etch_row_add(row, at.x2, at.x3);
}

void etch_smooth_ring(const struct etch_surface *s, struct etch_point_q8 centre, int32_t outer,
                      int32_t inner, const struct etch_cover_paint *paint, int16_t *cover)
{
    struct etch_smooth_ring ring = {centre, outer, inner};

    if (outer > 0 && inner < outer) {
        const struct etch_smooth_lines lines = etch_smooth_ring_lines(&ring, &ring, line);

        etch_smooth_lines_fill(s, &lines, paint, cover);
    }
}

void etch_smooth_disc(const struct etch_surface *s, struct etch_point_q8 centre, int32_t r,
                      const struct etch_cover_paint *paint, int16_t *cover)
{
    etch_smooth_ring(s, centre, r, 0, paint, cover);
}

void etch_smooth_circle(const struct etch_surface *s, struct etch_point_q8 centre, int32_t r,
                        int32_t width, const struct etch_cover_paint *paint, int16_t *cover)
{
    if (r >= 0 && width > 0)
        etch_smooth_ring(s, centre, r + (width - width / 2), r - width / 2, paint, cover);
}
