/* draw/image_nine.c: frames of any size from one image. Called by applications. See image.h. */
#include "image.h"

/* One axis: the ends of three pieces, in texels and in pixels from the rectangle's edge. */
struct axis {
    int16_t from[3], to_from[3]; /* texels from .. to_from - 1 */
    int16_t at[4];               /* pixels at[i] .. at[i + 1] - 1 */
};

static int16_t least(int32_t a, int32_t b)
{
    return (int16_t)(a < b ? a : b);
}

/* Borders `near` and `far` of n texels, over w >= 1 pixels. */
static void divide(struct axis *a, int16_t n, uint16_t near, uint16_t far, int16_t w)
{
    const int16_t first = least(near, n), last = least(far, (int32_t)n - first);
    const int32_t both = (int32_t)first + last;
    const bool narrow = w < both;
    const int16_t head = narrow ? (int16_t)((uint32_t)etch_mul_s16(w, first) / (uint32_t)both)
                                : first;
    const int16_t tail = narrow ? (int16_t)(w - head) : last;

    a->from[0] = 0, a->to_from[0] = head;
    a->from[1] = first, a->to_from[1] = (int16_t)(n - last);
    a->from[2] = (int16_t)(n - tail), a->to_from[2] = n;
    a->at[0] = 0, a->at[1] = head, a->at[2] = (int16_t)(w - tail), a->at[3] = w;
}

static void piece(const struct etch_surface *s, const struct etch_image_style *style, int32_t x,
                  int32_t y, const struct axis *across, const struct axis *down, uint8_t i,
                  uint8_t j)
{
    const struct etch_rect part = {across->from[i], down->from[j], across->to_from[i],
                                   down->to_from[j]};

    x += across->at[i], y += down->at[j];
    if (x <= INT16_MAX && y <= INT16_MAX) /* else right of or below every frame */
        etch_image_draw_scaled(s, style, part, (int16_t)x, (int16_t)y,
                               (int16_t)(across->at[i + 1] - across->at[i]),
                               (int16_t)(down->at[j + 1] - down->at[j]));
}

void etch_image_draw_nine(const struct etch_surface *s, const struct etch_image_style *style,
                          const struct etch_border *border, int16_t x, int16_t y, int16_t w,
                          int16_t h)
{
    const struct etch_rect all = etch_image_whole(style->image);
    struct axis across, down;

    if (w <= 0 || h <= 0 || etch_rect_is_empty(all))
        return;
    divide(&across, all.x1, border->left, border->right, w);
    divide(&down, all.y1, border->top, border->bottom, h);
    for (uint8_t j = 0; j < 3; j++)
        for (uint8_t i = 0; i < 3; i++)
            piece(s, style, x, y, &across, &down, i, j);
}
