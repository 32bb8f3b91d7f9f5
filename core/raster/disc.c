/* raster/disc.c: discs to runs. Called by draw/. See circle.h.
 *
 * The outline reaches, on the row j >= 0 from the centre, the half width w
 *
 *      j <= end:  w = y(j)                  the largest w with w^2 - w < r^2 - j^2
 *      j >  end:  w = last x with y(x) = j  the largest w with w^2 < r^2 - j^2 + j
 *
 * (octants and `end` as in circle.c; y(x) >= j <=> x^2 < r^2 - j^2 + j). w changes little from
 * row to row, so after one square root it is followed up or down.
 */
#include "octant.h"

struct width {
    int32_t rr, end; /* r^2, and the octant's last x */
    int32_t w;       /* of the row followed last */
};

/* Whether half width w lies on or inside the outline in row j; w >= 0. */
static bool is_inside(const struct width *h, int32_t w, int32_t j)
{
    return j <= h->end ? w * w - w < h->rr - j * j : w * w < h->rr - j * j + j;
}

static void width_follow(struct width *h, int32_t j)
{
    while (is_inside(h, h->w + 1, j))
        h->w++;
    while (!is_inside(h, h->w, j))
        h->w--;
}

void etch_circle_runs(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t r,
                      const struct etch_paint *paint)
{
    const struct etch_rect c = s->clip;
    const int32_t top = (int32_t)cy - r, bottom = (int32_t)cy + r + 1;
    int32_t y = top > c.y0 ? top : c.y0;
    const int32_t y1 = bottom < c.y1 ? bottom : c.y1;
    struct etch_run runs[ETCH_RUN_BLOCK];
    struct width h = {(int32_t)r * r, 0, 0};

    if (r < 0 || y >= y1 || (int32_t)cx - r >= c.x1 || (int32_t)cx + r < c.x0)
        return;
    if (r == 0)
        h.rr = 1, h.end = -1; /* the second rule then gives w = 0 in row 0 */
    else
        h.end = octant_end(r);
    h.w = etch_sqrt_u32((uint32_t)(h.rr - (y - cy) * (y - cy)));
    while (y < y1) {
        uint8_t n = 0;

        for (const int32_t start = y; y < y1 && y - start < ETCH_RUN_BLOCK; y++, n++) {
            int32_t x0, x1;

            width_follow(&h, y < cy ? cy - y : y - cy);
            x0 = cx - h.w, x1 = cx + h.w + 1;
            x0 = x0 < c.x0 ? c.x0 : x0 > c.x1 ? c.x1 : x0;
            x1 = x1 < c.x0 ? c.x0 : x1 > c.x1 ? c.x1 : x1;
            runs[n].x0 = (int16_t)x0;
            runs[n].x1 = (int16_t)x1;
        }
        paint->kernel(s, (int16_t)(y - n), runs, n, paint);
    }
}
