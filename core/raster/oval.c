/* raster/oval.c: walks the edge of an ellipse. Called by ellipses, rounded rectangles and rings.
 * See oval.h.
 *
 * With R = rx^2 and S = ry^2, or both divided by their common r^2, the pixel (a, b) is in the
 * ellipse iff F or G is not above 0:
 *
 *      F = 4 S a^2 + R (2 b - 1)^2 - 4 R ry^2        half a pixel up
 *      G = S (2 a - 1)^2 + 4 R b^2 - 4 R ry^2        half a pixel to the left
 *      F(a + 1) = F + 4 S (2 a + 1)   G(a + 1) = G + 8 S a
 *      F(b + 1) = F + 8 R b           G(b + 1) = G + 4 R (2 b + 1)
 *
 * For a <= rx and b <= ry each term is at most 2^62, and so is the sum. (0, b) needs no test: w >=
 * 0. */
#include "oval.h"

bool etch_oval_init(struct etch_oval *o, int32_t x0, int32_t x1, int32_t rx, int32_t ry,
                    struct etch_span view)
{
    const int32_t to_left = x0 - view.x0, to_right = view.x1 - 1 - x1;
    const int32_t far = to_left > to_right ? to_left : to_right;
    const int32_t near = x0 >= view.x1 ? x0 - view.x1 + 1 : x1 < view.x0 ? view.x0 - x1 : 0;

    if (rx < 0 || ry < 0 || near > rx)
        return false;
    o->rx = rx;
    o->ry = ry;
    o->down = rx == ry ? 1 : (uint32_t)rx * (uint32_t)rx;
    o->right = rx == ry ? 1 : (uint32_t)ry * (uint32_t)ry;
    o->least = near > 0 ? near - 1 : 0;
    o->most = far < 0 ? 0 : far + 1 < rx ? far + 1 : rx;
    return true;
}

static void place(const struct etch_oval *o, struct etch_oval_edge *e, int32_t a, int32_t b)
{
    const int64_t down = o->down, right = o->right, whole = 4 * down * (o->ry * o->ry);
    const int64_t up = etch_mul_s32(2 * b - 1, 2 * b - 1),
                  left = etch_mul_s32(2 * a - 1, 2 * a - 1);

    e->w = a;
    e->b = b;
    e->f = down * up - whole + 4 * right * (a * a);
    e->g = 4 * down * (b * b) - whole + right * left;
    e->f_right = 8 * right * a;
    e->f_down = 8 * down * b;
}

static bool is_inside(const struct etch_oval_edge *e)
{
    return e->f <= 0 || e->g <= 0;
}

/* The largest w between the limits that is inside, or the least. */
static void find(const struct etch_oval *o, struct etch_oval_edge *e, int32_t b)
{
    int32_t low = o->least, high = o->most;

    while (low < high) {
        const int32_t middle = (low + high + 1) / 2;

        place(o, e, middle, b);
        if (is_inside(e))
            low = middle;
        else
            high = middle - 1;
    }
    place(o, e, low, b);
}

static void step_down(const struct etch_oval *o, struct etch_oval_edge *e)
{
    const int64_t four = 4 * (int64_t)o->down;

    e->f += e->f_down;
    e->f_down += four;
    e->g += e->f_down;
    e->f_down += four;
    e->b++;
}

static void step_up(const struct etch_oval *o, struct etch_oval_edge *e)
{
    const int64_t four = 4 * (int64_t)o->down;

    e->f_down -= four;
    e->g -= e->f_down;
    e->f_down -= four;
    e->f -= e->f_down;
    e->b--;
}

/* Where a step down led out, back inside. */
static void shrink(const struct etch_oval *o, struct etch_oval_edge *e)
{
    const int64_t four = 4 * (int64_t)o->right;

    while (e->w > o->least && !is_inside(e)) {
        e->f_right -= four;
        e->f -= e->f_right;
        e->f_right -= four;
        e->g -= e->f_right;
        e->w--;
    }
}

static void grow(const struct etch_oval *o, struct etch_oval_edge *e)
{
    const int64_t four = 4 * (int64_t)o->right;

    while (e->w < o->most) {
        const int64_t g = e->g + e->f_right, f = e->f + e->f_right + four;

        if (f > 0 && g > 0)
            break;
        e->f = f;
        e->g = g;
        e->f_right += 2 * four;
        e->w++;
    }
}

int32_t etch_oval_width(const struct etch_oval *o, struct etch_oval_edge *e, int32_t b)
{
    if (b > o->ry)
        return -1;
    if (b == e->b + 1) {
        step_down(o, e);
        shrink(o, e);
    } else if (b == e->b - 1) {
        step_up(o, e);
        grow(o, e);
    } else if (b != e->b) {
        find(o, e, b);
    }
    return e->w;
}
