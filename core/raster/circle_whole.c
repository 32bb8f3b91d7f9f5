/* raster/circle_whole.c: a circle that no clip cuts, four octants at a time. Called by circle.c.
 * See octant.h. */
#include "octant.h"

/* Four pixels for one decision: right and left of the centre, below and above. */
struct four {
    uint16_t *right, *left;
    ptrdiff_t above; /* from those below */
};

ETCH_INLINE void four_write(const struct four *four, uint16_t color)
{
    *four->right = color;
    *four->left = color;
    four->right[four->above] = color;
    four->left[four->above] = color;
}

static void flat(uint16_t *centre, ptrdiff_t row, int32_t r, int32_t end, uint16_t color)
{
    uint16_t *const top = centre - row * (ptrdiff_t)r, *const bottom = centre + row * (ptrdiff_t)r;
    struct four four = {bottom, bottom, top - bottom};
    int32_t right = -1, down = 2 * r - 2, d = -r;

    *top = color;
    *bottom = color;
    while (right != 2 * end - 1) {
        right += 2;
        four.right++, four.left--;
        d += right;
        if (d >= 0) {
            four.right -= row, four.left -= row, four.above += 2 * row;
            d -= down;
            down -= 2;
        }
        four_write(&four, color);
    }
}

static void steep(uint16_t *centre, ptrdiff_t row, int32_t r, int32_t end, uint16_t color)
{
    uint16_t *const east = centre + r, *const west = centre - r;
    struct four four = {east, west, 0};
    int32_t right = -1, down = 2 * r - 2, d = -r;

    *east = color;
    *west = color;
    while (right != 2 * end - 1) {
        right += 2;
        four.right += row, four.left += row, four.above -= 2 * row;
        d += right;
        if (d >= 0) {
            four.right--, four.left++;
            d -= down;
            down -= 2;
        }
        four_write(&four, color);
    }
}

void etch_circle_whole(uint16_t *centre, ptrdiff_t row, int32_t r, int32_t end, int32_t steep_end,
                       uint16_t color)
{
    flat(centre, row, r, end, color);
    steep(centre, row, r, steep_end, color);
}
