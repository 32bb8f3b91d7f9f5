/* frame/smooth_pixel.c: finding and following the edge at a pixel. Called by smooth.c for every
 * pixel. See smooth.h, whose steps are numbered as here. */
#include "smooth_pixel.h"

uint16_t etch_smooth_color(const struct smooth_place *p, int32_t dx, int32_t dy)
{
    const struct etch_rect *s = &p->carry->source;
    int32_t x = p->x + dx;

    x = x < s->x0 ? s->x0 : x;
    x = x < s->x1 ? x : s->x1 - 1;
    return etch_carry_row(p->carry, p->source, p->y + dy)[x - s->x0];
}

static int16_t luma(const struct smooth_place *p, int32_t dx, int32_t dy)
{
    return smooth_luma(etch_smooth_color(p, dx, dy));
}

static int16_t size_of(int16_t v)
{
    return v < 0 ? (int16_t)-v : v;
}

/* |a + c - 2 b| */
static int16_t bend(int16_t a, int16_t b, int16_t c)
{
    return size_of((int16_t)(a + c - 2 * b));
}

/* Step 2; false if there is no edge. */
static bool find_edge(const struct smooth_place *p, struct smooth_edge *edge)
{
    const int16_t m = luma(p, 0, 0), n = luma(p, 0, -1), s = luma(p, 0, 1);
    const int16_t w = luma(p, -1, 0), e = luma(p, 1, 0);
    const int16_t nw = luma(p, -1, -1), ne = luma(p, 1, -1);
    const int16_t sw = luma(p, -1, 1), se = luma(p, 1, 1);
    const int16_t down = (int16_t)(bend(nw, w, sw) + 2 * bend(n, m, s) + bend(ne, e, se));
    const int16_t across = (int16_t)(bend(nw, n, ne) + 2 * bend(w, m, e) + bend(sw, s, se));

    edge->along_row = down >= across;
    const int16_t before = (int16_t)((edge->along_row ? n : w) - m);
    const int16_t after = (int16_t)((edge->along_row ? s : e) - m);

    edge->side = size_of(before) >= size_of(after) ? -1 : 1;
    edge->step = edge->side < 0 ? before : after;
    edge->sum = (int16_t)(2 * m + edge->step);
    return edge->step != 0;
}

/* Step 3 in one direction: pixels to the end of the edge; *turn is the change of luma there, 0 if
 * the end is beyond reach. */
static uint8_t follow(const struct smooth_place *p, const struct smooth_edge *edge,
                      int8_t direction, int16_t *turn)
{
    const uint8_t reach = edge->along_row ? ETCH_SMOOTH_COLUMNS : p->carry->rows;

    for (uint8_t k = 1; k <= reach; k++) {
        const int32_t along = direction * k, side = edge->side;
        const int16_t sum = (int16_t)(edge->along_row ? luma(p, along, 0) + luma(p, along, side)
                                                      : luma(p, 0, along) + luma(p, side, along));

        *turn = (int16_t)(sum - edge->sum);
        if (2 * size_of(*turn) >= size_of(edge->step))
            return k;
    }
    *turn = 0;
    return (uint8_t)(reach + 1);
}

struct smooth_blend etch_smooth_find(const struct smooth_place *p)
{
    struct smooth_blend blend = {0, 1, 0, 0};
    struct smooth_edge edge;
    int16_t turn_n, turn_p;

    if (!find_edge(p, &edge))
        return blend;
    const uint8_t n = follow(p, &edge, -1, &turn_n), q = follow(p, &edge, 1, &turn_p);
    const int16_t turn = n <= q ? turn_n : turn_p;

    if (turn == 0 || (turn < 0) != (edge.step < 0)) /* step 4 */
        return blend;
    const uint8_t length = (uint8_t)(n + q - 1), near = n <= q ? n : q;

    blend.numerator = (uint8_t)(length - 2 * near + 1);
    blend.denominator = (uint8_t)(2 * length);
    blend.dx = edge.along_row ? 0 : edge.side;
    blend.dy = edge.along_row ? edge.side : 0;
    return blend;
}
