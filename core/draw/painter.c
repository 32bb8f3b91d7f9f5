/* draw/painter.c: keeps triangles to be sorted by depth, and draws them. The sink is called by
 * assembly and draw/mesh, the drawing by the application, once a strip. See painter.h. */
#include "painter.h"
#include "painter_steps.h"

bool etch_painter_take(struct etch_painter_triangle *t, const struct etch_vertex v[3])
{
    t->z_far = 0;
    for (uint8_t i = 0; i < 3; i++) {
        t->v[i] = v[i];
        if (v[i].z_q16 > t->z_far)
            t->z_far = v[i].z_q16;
    }
    t->moved = false;
    return etch_painter_turn(&v[0], &v[1], &v[2]) != 0;
}

static void keep(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    /* sink is the first member, so it has the address of the whole */
    struct etch_painter *const p = (struct etch_painter *)(void *)sink;
    const struct etch_vertex corner[3] = {*v[0], *v[1], *v[2]};
    struct etch_painter_triangle t;

    if (!etch_painter_take(&t, corner))
        return;
    if (p->count == p->room) {
        p->lost = (uint16_t)(p->lost + (p->lost != UINT16_MAX));
        return;
    }
    t.next = ETCH_PAINTER_NONE;
    t.whole = p->count;
    p->triangle[p->count++] = t;
}

void etch_painter_init(struct etch_painter *p, struct etch_painter_triangle *triangle,
                       uint16_t room)
{
    const struct etch_sink sink = {.triangle = keep};

    ETCH_ASSERT(room != ETCH_PAINTER_NONE);
    p->sink = sink;
    p->triangle = triangle;
    p->room = room;
    p->count = p->lost = 0;
    p->first = ETCH_PAINTER_NONE;
    p->uncut = false;
}

void etch_painter_draw(const struct etch_painter *p, struct etch_sink *to)
{
    for (uint16_t at = p->first; at != ETCH_PAINTER_NONE; at = p->triangle[at].next) {
        const struct etch_vertex *const v = p->triangle[at].v;
        const struct etch_vertex *const corner[3] = {&v[0], &v[1], &v[2]};

        to->triangle(to, corner);
    }
}
