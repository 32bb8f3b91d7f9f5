/* fragment/gradient_linear.c: rows of linear gradients. A brush; see gradient.h.
 *
 * Along a row s grows by dx. Where 0 <= s < d the entry is i = floor(N s / d), N = 2^bits, kept
 * with the remainder e = N s - i d and stepped by N dx = q d + r. */
#include "../base/fill.h"
#include "gradient.h"

/* i and e of s, by long division: s < d < 2^31. */
static uint32_t divide(uint32_t s, uint32_t d, uint8_t bits, uint32_t *rest)
{
    uint32_t i = 0;

    for (; bits != 0; bits--) {
        s <<= 1;
        i <<= 1;
        if (s >= d) {
            s -= d;
            i++;
        }
    }
    *rest = s;
    return i;
}

/* Entries from the one of s on, until they leave the ramp; returns the pixel after them. */
static uint16_t *inside(const struct etch_gradient_linear *g, uint32_t s, uint16_t *color,
                        const uint16_t *end)
{
    const uint16_t *const ramp = g->ramp->color;
    const uint32_t d = g->square, most = UINT32_C(1) << g->ramp->bits;
    const bool back = g->dx < 0;
    const uint32_t step = (uint32_t)(back ? -g->dx : g->dx) * most; /* below 2^24 */
    const uint32_t whole = step / d, rest = step - whole * d;
    const int32_t q = back ? -(int32_t)whole - (rest != 0) : (int32_t)whole; /* floor */
    const uint32_t r = back && rest != 0 ? d - rest : rest;
    uint32_t e;
    int32_t i = (int32_t)divide(s, d, g->ramp->bits, &e);

    while (color != end && (uint32_t)i < most) {
        *color++ = ramp[i];
        i += q;
        e += r; /* both below d */
        if (e >= d) {
            e -= d;
            i++;
        }
    }
    return color;
}

static void colors(const struct etch_brush *brush, int16_t x, int16_t y, uint16_t n,
                   uint16_t *color)
{
    const struct etch_gradient_linear *const g = (const struct etch_gradient_linear *)brush;
    const uint16_t *const ramp = g->ramp->color, *const end = color + n;
    const uint16_t first = ramp[0], last = ramp[(1 << g->ramp->bits) - 1];
    int64_t s = etch_mul_s32(x - (int32_t)g->x0, g->dx) + etch_mul_s32(y - (int32_t)g->y0, g->dy);

    if (g->dx == 0) {
        uint32_t e;
        const uint16_t all = s < 0 ? first
                             : s >= g->square
                                 ? last
                                 : ramp[divide((uint32_t)s, g->square, g->ramp->bits, &e)];

        etch_fill_rows(color, n, all, 1, 0);
        return;
    }
    for (; color != end && (s < 0 || s >= g->square); s += g->dx)
        *color++ = s < 0 ? first : last;
    if (color != end)
        color = inside(g, (uint32_t)s, color, end);
    while (color != end)
        *color++ = g->dx < 0 ? first : last;
}

enum etch_status etch_gradient_linear_init(struct etch_gradient_linear *g,
                                           const struct etch_ramp *ramp, int16_t x0, int16_t y0,
                                           int16_t x1, int16_t y1)
{
    const int32_t dx = (int32_t)x1 - x0, dy = (int32_t)y1 - y0;
    const int64_t square = etch_mul_s32(dx, dx) + etch_mul_s32(dy, dy);

    if (square == 0 || square > INT32_MAX)
        return ETCH_EINVAL;
    g->brush.colors = colors;
    g->ramp = ramp;
    g->x0 = x0;
    g->y0 = y0;
    g->dx = dx;
    g->dy = dy;
    g->square = (uint32_t)square;
    return ETCH_OK;
}
