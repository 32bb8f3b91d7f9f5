/* raster/octant.c: parts of an octant, and walks through it. Called by circle.c. See octant.h. */
#include "octant.h"

/* ceil(sqrt(v)) and floor(sqrt(v)) for v <= 2^30 + 2^15; v <= 0 gives 0 and -1 below 0. */
static int32_t sqrt_up(int32_t v)
{
    const int32_t root = v > 0 ? etch_sqrt_u32((uint32_t)v) : 0;

    return root * root < v ? root + 1 : root;
}

static int32_t sqrt_down(int32_t v)
{
    return v < 0 ? -1 : (int32_t)etch_sqrt_u32((uint32_t)v);
}

void etch_octant_cut_y(struct etch_octant_part *part, int32_t lo, int32_t hi, int32_t r)
{
    if (hi < 0 || lo > r) {
        part->to = -1;
        return;
    }
    if (hi < r) /* y(x) <= hi  <=>  x^2 >= r^2 - hi^2 - hi */
        octant_cut_x(part, sqrt_up(r * r - hi * hi - hi), part->to);
    if (lo > 0) /* y(x) >= lo  <=>  x^2 <= r^2 - lo^2 + lo - 1 */
        octant_cut_x(part, part->from, sqrt_down(r * r - lo * lo + lo - 1));
}

/* y(x). */
static int32_t outline_y(int32_t x, int32_t r)
{
    const int32_t square = r * r - x * x;
    int32_t y;

    if (x <= 1)
        return r;
    y = sqrt_down(square);
    return y + (square - y * y > y); /* nearest */
}

int32_t etch_octant_start(struct etch_octant_pen *pen, int32_t x, int32_t r)
{
    const int32_t y = outline_y(x, r);

    pen->right = 2 * x - 1;
    pen->down = 2 * y - 2;
    pen->d = x * x + y * y - y - r * r;
    return y;
}

uint16_t *etch_octant_walk(struct etch_octant_pen *pen, uint16_t *p, ptrdiff_t along,
                           ptrdiff_t across, int32_t to, uint16_t color)
{
    const int32_t last = 2 * to - 1;
    int32_t right = pen->right, down = pen->down, d = pen->d;

    while (right != last) {
        right += 2;
        p += along;
        d += right;
        if (d >= 0) {
            p -= across;
            d -= down;
            down -= 2;
        }
        *p = color;
    }
    *pen = (struct etch_octant_pen){right, down, d};
    return p;
}
