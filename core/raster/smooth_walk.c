/* raster/smooth_walk.c: walks the 16 lines of each row. Called by smooth_nonzero.c and
 * smooth_evenodd.c. See smooth.h.
 *
 * On line k an edge lies at x = a.x + floor(dx t / dy) with t = 16 k + 8 - a.y, 0 <= t < dy: the product is
 * below 2^49. From line to line it steps by 16 dx / dy, |16 dx| <= 2^28. Each row begins anew, so that no
 * strip and no clip matters. */
#include "smooth_walk.h"

/* Puts the edge on a line that it crosses. */
static void place(struct etch_smooth_edge *g, int32_t line)
{
    const int32_t t = 16 * line + 8 - g->a.y;
    const int64_t n = etch_mul_s32(g->dx, t);
    const struct etch_quotient d = etch_divide_u64((uint64_t)(n < 0 ? -n : n), (uint64_t)g->dy);
    const int32_t q = (int32_t)d.quotient, r = (int32_t)d.remainder;

    g->x = n < 0 ? g->a.x - q - (r != 0) : g->a.x + q;
    g->e = n < 0 && r != 0 ? g->dy - r : r;
}

static void step(struct etch_smooth_edge *g)
{
    const int32_t d = 16 * g->dx;
    const int32_t q = d / g->dy - (d % g->dy < 0);

    g->x += q;
    g->e += d - q * g->dy;
    if (g->e >= g->dy)
        g->e -= g->dy, g->x++;
}

static void insert(struct etch_smooth_edge **list, struct etch_smooth_edge *g)
{
    while (*list != NULL && (*list)->x < g->x)
        list = &(*list)->next;
    g->next = *list;
    *list = g;
}

/* Of the edges that crossed the line before, those that cross this one, in order. */
static struct etch_smooth_edge *next_line(struct etch_smooth_edge *before, int32_t line)
{
    struct etch_smooth_edge *list = NULL, *next;

    for (; before != NULL; before = next) {
        next = before->next;
        if (before->line1 > line) {
            step(before);
            insert(&list, before);
        }
    }
    return list;
}

/* Moves the edges that begin at or above the line from `waiting` into the list. */
static void take_waiting(struct etch_smooth_edge **list, struct etch_smooth_edge **waiting,
                         int32_t line)
{
    while (*waiting != NULL) {
        struct etch_smooth_edge *const g = *waiting;

        if (g->line0 <= line) {
            *waiting = g->next;
            insert(list, g);
        } else {
            waiting = &g->next;
        }
    }
}

static void walk_row(struct etch_smooth *p, int16_t y, struct etch_smooth_row *row,
                     etch_smooth_line *line)
{
    const int32_t top = 16 * (int32_t)y;
    struct etch_smooth_edge *active = NULL, *waiting = NULL;

    for (uint16_t i = 0; i < p->count; i++) {
        struct etch_smooth_edge *const g = &p->edge[i];

        if (g->line0 < top + 16 && g->line1 > top) {
            place(g, g->line0 > top ? g->line0 : top);
            g->next = waiting;
            waiting = g;
        }
    }
    for (int32_t k = top; k < top + 16 && (active != NULL || waiting != NULL); k++) {
        active = next_line(active, k);
        take_waiting(&active, &waiting, k);
        line(row, active);
    }
}

/* Sums the changes up, hands over what is covered and leaves the row zero. All that begins in a row ends in
 * it, at the clip's end at the latest, so the last sum is 0. */
static void hand_over(const struct etch_surface *s, int16_t y, const struct etch_smooth_row *row,
                      const struct etch_cover_paint *paint)
{
    const int32_t columns = row->width >> 8;
    int32_t sum = 0, begin = row->from;

    for (int32_t i = row->from; i <= row->to; i++) {
        sum += row->change[i];
        row->change[i] = (int16_t)sum;
        if (sum == 0 || i == columns) {
            if (begin < i)
                paint->kernel(s, (int16_t)(s->clip.x0 + begin), y, (uint16_t)(i - begin),
                              row->change + begin, paint);
            begin = i + 1;
        }
    }
    for (int32_t i = row->from; i <= row->to; i++)
        row->change[i] = 0;
}

void etch_smooth_walk(const struct etch_surface *surface, struct etch_smooth *p,
                      const struct etch_cover_paint *paint, int16_t *cover, etch_smooth_line *line)
{
    const struct etch_rect c = surface->clip;
    const int32_t columns = (int32_t)c.x1 - c.x0;
    struct etch_smooth_row row = {cover, c.x0 * INT32_C(256), columns * 256, 0, 0};

    if (p->status != ETCH_OK || p->count == 0 || etch_rect_is_empty(c))
        return;
    for (int32_t i = 0; i <= columns; i++)
        cover[i] = 0;
    for (int16_t y = c.y0; y < c.y1; y++) {
        row.from = columns + 1;
        row.to = -1;
        walk_row(p, y, &row, line);
        hand_over(surface, y, &row, paint);
    }
}
