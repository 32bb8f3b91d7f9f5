/* raster/disc_half.c: walks the edge of a disc. Called by rings and arcs. See disc_half.h.
 *
 * oval.c's F <= 0 or G <= 0 with R = S = 1, in whole numbers: F <= 0 iff a^2 + b^2 - r^2 < b, G <=
 * 0 iff it is < a. For a, b <= r it is within -2^30 .. 2^30. */
#include "disc_half.h"

void etch_disc_view_init(struct etch_disc_view *view, int32_t x, int32_t x0, int32_t x1)
{
    const int32_t to_left = x - x0, to_right = x1 - 1 - x;
    const int32_t far = (to_left > to_right ? to_left : to_right) + 1;

    view->near = to_right < 0 ? -to_right : to_left < 0 ? -to_left : 0;
    view->far = far > 0 ? far : 0;
}

bool etch_disc_half_init(struct etch_disc_half *h, const struct etch_disc_view *view, int32_t r)
{
    h->r = r;
    h->b = -2; /* no row, and next to none */
    return r >= 0 && view->near <= r;
}

static bool is_inside(int32_t e, int32_t w, int32_t b)
{
    return e < w || e < b;
}

/* The largest w between the limits that is inside, or the least. */
static int32_t find(int32_t r, int32_t b, int32_t low, int32_t high)
{
    while (low < high) {
        const int32_t middle = (low + high + 1) / 2;

        if (is_inside(middle * middle - (r - b) * (r + b), middle, b))
            low = middle;
        else
            high = middle - 1;
    }
    return low;
}

int32_t etch_disc_half_width(struct etch_disc_half *h, const struct etch_disc_view *view, int32_t b)
{
    const int32_t least = view->near > 0 ? view->near - 1 : 0;
    const int32_t most = view->far < h->r ? view->far : h->r;
    int32_t w = h->w, e = h->e;

    if (b > h->r)
        return -1;
    if (b == h->b + 1) {
        e += 2 * b - 1;
        while (w > least && !is_inside(e, w, b)) {
            e -= 2 * w - 1;
            w--;
        }
    } else if (b == h->b - 1) {
        e -= 2 * b + 1;
        while (w < most && is_inside(e + 2 * w + 1, w + 1, b)) {
            e += 2 * w + 1;
            w++;
        }
    } else if (b != h->b) {
        w = find(h->r, b, least, most);
        e = w * w - (h->r - b) * (h->r + b);
    }
    h->w = w;
    h->e = e;
    h->b = b;
    return w;
}
