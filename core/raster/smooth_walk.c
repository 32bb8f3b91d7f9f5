/* raster/smooth_walk.c: walks the 16 lines of each row. Called by smooth_nonzero.c and
 * smooth_evenodd.c. See smooth.h.
 *
 * Each row begins anew, so that no strip and no clip matters. */
#include "smooth_walk.h"

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
            etch_smooth_edge_step(before);
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
                     etch_smooth_rule *line)
{
    const int32_t top = 16 * (int32_t)y;
    struct etch_smooth_edge *active = NULL, *waiting = NULL;

    for (uint16_t i = 0; i < p->count; i++) {
        struct etch_smooth_edge *const g = &p->edge[i];

        if (g->line0 < top + 16 && g->line1 > top) {
            etch_smooth_edge_place(g, g->line0 > top ? g->line0 : top);
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

void etch_smooth_walk(const struct etch_surface *surface, struct etch_smooth *p,
                      const struct etch_cover_paint *paint, int16_t *cover, etch_smooth_rule *line)
{
    const struct etch_rect c = surface->clip;
    struct etch_smooth_row row;

    if (p->status != ETCH_OK || p->count == 0 || etch_rect_is_empty(c))
        return;
    etch_smooth_row_init(&row, surface, cover);
    for (int16_t y = c.y0; y < c.y1; y++) {
        walk_row(p, y, &row, line);
        etch_smooth_row_end(&row, surface, y, paint);
    }
}
