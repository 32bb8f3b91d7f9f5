/* raster/ring.c: rings to runs. Called by draw/ and applications; arc.c takes its rows. See arc.h.
 */
#include "ring.h"
#include "arc.h"

bool etch_ring_init_radii(struct etch_ring *p, int32_t outer, int32_t inner)
{
    if (!etch_disc_half_init(&p->inner, &p->view, inner))
        p->inner.r = -1;
    return inner < outer && etch_disc_half_init(&p->outer, &p->view, outer);
}

struct etch_ring_row etch_ring_at(struct etch_ring *p, int32_t y)
{
    const int32_t b = y < p->cy ? p->cy - y : y - p->cy;
    const struct etch_ring_row at = {etch_disc_half_width(&p->outer, &p->view, b),
                                     etch_disc_half_width(&p->inner, &p->view, b)};

    return at;
}

void etch_ring_spans(void *shape, int32_t y, struct etch_row *row)
{
    struct etch_ring *const p = shape;
    const struct etch_ring_row at = etch_ring_at(p, y);

    etch_row_add(row, p->cx - at.w, p->cx - at.hole);
    etch_row_add(row, p->cx + at.hole + 1, p->cx + at.w + 1);
}

void etch_ring_runs(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t outer,
                    int16_t inner, const struct etch_paint *paint)
{
    struct etch_ring p;

    if (etch_ring_init(&p, cx, cy, outer, inner, etch_rows_seen(s))) {
        const struct etch_rows rows = etch_ring_rows(&p, &p, etch_ring_spans);

        etch_rows_fill(s, &rows, paint);
    }
}
