/* draw/painter_sort.c: Newell's order. Called by the application, once a frame. See painter.h.
 *
 * The list begins with the triangles that were moved since the last cut, the latest first; behind
 * them all are sorted by z_far, which is where the search for overlaps in depth may end. */
#include "painter_steps.h"

#define NONE ETCH_PAINTER_NONE

/* Two lists sorted by z_far, farthest first, to one; ties from a first. */
static uint16_t merge(struct etch_painter_triangle *t, uint16_t a, uint16_t b)
{
    uint16_t first = NONE, *end = &first;

    while (a != NONE && b != NONE) {
        uint16_t *const from = t[b].z_far > t[a].z_far ? &b : &a;

        *end = *from;
        end = &t[*end].next;
        *from = *end;
    }
    *end = a != NONE ? a : b;
    return first;
}

/* All triangles, sorted: sorted[i] is none or 2^i of them, and a later one. */
static uint16_t sort(struct etch_painter *p)
{
    uint16_t sorted[16], list = NONE;
    uint8_t i;

    for (i = 0; i < 16; i++)
        sorted[i] = NONE;
    for (uint16_t at = 0; at < p->count; at++) {
        uint16_t more = at;

        p->triangle[at].next = NONE;
        for (i = 0; sorted[i] != NONE; i++) {
            more = merge(p->triangle, sorted[i], more);
            sorted[i] = NONE;
        }
        sorted[i] = more;
    }
    for (i = 0; i < 16; i++)
        list = merge(p->triangle, sorted[i], list);
    return list;
}

static void insert(struct etch_painter_triangle *t, uint16_t *list, uint16_t at)
{
    while (*list != NONE && t[*list].z_far >= t[at].z_far)
        list = &t[*list].next;
    t[at].moved = false;
    t[at].next = *list;
    *list = at;
}

/* Takes `at` out of the list. */
static void take_out(struct etch_painter_triangle *t, uint16_t *list, uint16_t at)
{
    while (*list != at)
        list = &t[*list].next;
    *list = t[at].next;
}

/* Cuts `at` by the plane of `by`, if it does cut it and there is room, and begins anew: all that
 * was moved goes back to its place. Once a cut found no room none is tried: most would not either,
 * and to look for one in every ring takes its square. */
static bool cut(struct etch_painter *p, uint16_t *list, uint16_t at, uint16_t by)
{
    struct etch_painter_triangle *const t = p->triangle;
    const uint16_t after = t[at].next;
    uint16_t piece[3], moved = NONE;
    uint8_t n;

    if (p->uncut || etch_painter_cut(p, at, by, piece, &n) != ETCH_PAINTER_CUT)
        return false;
    t[at].next = after; /* its place may be a piece's now */
    take_out(t, list, at);
    while (*list != NONE && t[*list].moved) {
        const uint16_t first = *list;

        *list = t[first].next;
        t[first].next = moved;
        moved = first;
    }
    while (moved != NONE) {
        const uint16_t first = moved;

        moved = t[first].next;
        insert(t, list, first);
    }
    for (uint8_t i = 0; i < n; i++)
        insert(t, list, piece[i]);
    return true;
}

/* Cuts one of the ring of moved triangles from the first of the list to `last`, each in the way of
 * the next. A plane that cut none would part the ring in two, so there is a cut unless all of them
 * are too near. */
static bool cut_ring(struct etch_painter *p, uint16_t *list, uint16_t last)
{
    const struct etch_painter_triangle *const t = p->triangle;
    const uint16_t end = t[last].next;

    for (uint16_t a = *list; a != end && !p->uncut; a = t[a].next)
        for (uint16_t b = *list; b != end; b = t[b].next)
            if (a != b && !etch_painter_is_apart(&t[a], &t[b]) && cut(p, list, a, b))
                return true;
    return false;
}

static uint32_t nearest_depth(const struct etch_painter_triangle *t)
{
    const uint32_t a = t->v[0].z_q16, b = t->v[1].z_q16, c = t->v[2].z_q16;

    return a < b ? a < c ? a : c : b < c ? b : c;
}

/* Whether the first of the list may be drawn; else the list was changed: another was moved before
 * it, or one was cut. */
static bool is_settled(struct etch_painter *p, uint16_t *list)
{
    struct etch_painter_triangle *const t = p->triangle;
    const uint16_t far = *list;
    const uint32_t nearest = nearest_depth(&t[far]);

    for (uint16_t at = t[far].next; at != NONE; at = t[at].next) {
        if (t[at].z_far <= nearest) {
            if (!t[at].moved)
                return true;
            continue;
        }
        if (etch_painter_extents_apart(&t[far], &t[at]) || etch_painter_is_behind(p, far, at) ||
            etch_painter_is_apart(&t[far], &t[at]))
            continue;
        if (t[at].moved) {
            if (cut_ring(p, list, at))
                return false;
        } else if (etch_painter_is_behind(p, at, far)) {
            take_out(t, list, at);
            t[at].next = *list;
            t[at].moved = true;
            *list = at;
            return false;
        } else if (cut(p, list, far, at)) {
            return false;
        }
    }
    return true;
}

enum etch_status etch_painter_sort(struct etch_painter *p)
{
    uint16_t list = sort(p), *end = &p->first;

    while (list != NONE) {
        const uint16_t at = list;

        if (!is_settled(p, &list))
            continue;
        list = p->triangle[at].next;
        *end = at;
        end = &p->triangle[at].next;
    }
    *end = NONE;
    return p->lost != 0 || p->uncut ? ETCH_ENOMEM : ETCH_OK;
}
