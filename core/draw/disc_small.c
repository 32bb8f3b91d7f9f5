/* draw/disc_small.c: circles and discs in little flash. Called by applications. See shapes_small.h.
 *
 * On the row j from the centre the outline reaches the half width w, the largest with
 *
 *      w^2 - w < r^2 - j^2          where it is flatter than steep: 2 j^2 - j < r^2
 *      w^2 < r^2 - j^2 + j          elsewhere: the last column whose nearest row is j or beyond
 *
 * (raster/disc.c), and begins behind the last column whose nearest row is j + 1 or beyond.
 */
#include "shapes_small.h"

static int32_t reach(int32_t r, int32_t j, bool flat)
{
    const int32_t n = (r != 0 ? r * r : 1) - j * j + (flat ? j : 0);
    int32_t w = etch_sqrt_u32((uint32_t)n) + 1;

    while (w * w - (flat ? 0 : w) >= n)
        w--;
    return w;
}

static void rows(const struct etch_surface *s, int16_t cx, int16_t cy, int32_t r, uint16_t color,
                 bool filled)
{
    const int32_t bottom = cy + r + 1, y1 = bottom < s->clip.y1 ? bottom : s->clip.y1;
    int32_t y = cy - r > s->clip.y0 ? cy - r : s->clip.y0;

    for (; y < y1; y++) { /* none if r < 0: then cy - r > cy + r */
        const int32_t j = y < cy ? cy - y : y - cy, w = reach(r, j, 2 * j * j - j >= r * r);
        int32_t hole = 0; /* columns -hole + 1 .. hole - 1 are not drawn */

        if (!filled && j != r) {
            hole = reach(r, j + 1, true) + 1;
            hole = hole < w ? hole : w;
        }
        etch_span_fill_small(s, y, cx - w, hole != 0 ? cx - hole + 1 : cx + w + 1, color);
        if (hole != 0)
            etch_span_fill_small(s, y, cx + hole, cx + w + 1, color);
    }
}

void etch_circle_fill_small(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t r,
                            uint16_t color)
{
    rows(s, cx, cy, r, color, true);
}

void etch_circle_draw_small(const struct etch_surface *s, int16_t cx, int16_t cy, int16_t r,
                            uint16_t color)
{
    rows(s, cx, cy, r, color, false);
}
