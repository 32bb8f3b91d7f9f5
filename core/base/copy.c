/* base/copy.c: rectangles of elements to another place. Called by what copies and scrolls surfaces.
 * See copy.h. */
#include "copy.h"

/* From the last to the first: `to` lies above `from` in the same row. */
static void copy_back(uint16_t *to, const uint16_t *from, uint32_t n)
{
    for (; n >= 4; n -= 4) {
        to[n - 1] = from[n - 1], to[n - 2] = from[n - 2];
        to[n - 3] = from[n - 3], to[n - 4] = from[n - 4];
    }
    for (; n != 0; n--)
        to[n - 1] = from[n - 1];
}

/* Every element moves by the same distance. Upwards in memory the last goes first: rows from below,
 * and inside a row from the right if it moves less than its length. */
void etch_copy_rows(const struct etch_copy *c, uint32_t n, uint32_t rows)
{
    const bool up = (uintptr_t)c->to > (uintptr_t)c->from;
    const bool back = up && ((uintptr_t)c->to - (uintptr_t)c->from) / 2 < n;

    for (uint32_t i = 0; i < rows; i++) {
        const size_t row = (size_t)(up ? rows - 1 - i : i);
        uint16_t *const to = c->to + row * c->to_stride;
        const uint16_t *const from = c->from + row * c->from_stride;

        if (back)
            copy_back(to, from, n);
        else
            etch_copy_row(to, from, n);
    }
}
