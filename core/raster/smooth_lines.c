/* raster/smooth_lines.c: the rows of shapes that know their lines. Called by smooth_ring.c and the
 * like. See smooth_lines.h. */
#include "smooth_lines.h"
#include "smooth_walk.h"

void etch_smooth_lines_fill(const struct etch_surface *s, const struct etch_smooth_lines *lines,
                            const struct etch_cover_paint *paint, int16_t *cover)
{
    const struct etch_rect c = s->clip;
    const int32_t top = lines->top >> 8, bottom = (lines->bottom >> 8) + 1;
    const int16_t y1 = bottom < c.y1 ? (int16_t)bottom : c.y1;
    struct etch_smooth_row row;

    if (bottom <= c.y0 || top >= c.y1 || etch_rect_is_empty(c))
        return;
    etch_smooth_row_init(&row, s, cover);
    for (int16_t y = top > c.y0 ? (int16_t)top : c.y0; y < y1; y++) {
        const int32_t first = y * INT32_C(256) + 8;

        for (int32_t at = first; at < first + 256; at += 16) {
            struct etch_row spans;

            spans.count = 0;
            lines->line(lines->shape, at, &spans);
            for (uint8_t i = 0; i < spans.count; i++) {
                etch_smooth_mark(&row, spans.span[i].x0, 1);
                etch_smooth_mark(&row, spans.span[i].x1, -1);
            }
        }
        etch_smooth_row_end(&row, s, y, paint);
    }
}

/* Of 32 bits of it at once, and the bits below by comparing: (root + bit)^2 <= v. */
int32_t etch_smooth_half(int32_t r, int32_t y)
{
    const int64_t v = etch_mul_s32(r, r) - etch_mul_s32(y, y);
    uint8_t shift = 0;
    int32_t root;

    if (v < 0)
        return -1;
    while (v >> (2 * shift) > UINT32_MAX)
        shift++;
    root = (int32_t)((uint32_t)etch_sqrt_u32((uint32_t)(v >> (2 * shift))) << shift);
    for (int32_t bit = INT32_C(1) << shift >> 1; bit != 0; bit >>= 1)
        if (etch_mul_s32(root + bit, root + bit) <= v)
            root += bit;
    return root;
}
