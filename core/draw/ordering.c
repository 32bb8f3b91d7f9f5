/* draw/ordering.c: triangles sorted into buckets by depth. The sink is called by assembly and
 * draw/mesh, the drawing by the application, once a strip. See ordering.h. */
#include "ordering.h"

/* The bucket of the mean depth: m <= 65535, so m buckets / 65536 < buckets. */
static uint16_t place(const struct etch_ordering *o, const struct etch_vertex *const v[3])
{
    const uint64_t sum = (uint64_t)v[0]->z_q16 + v[1]->z_q16 + v[2]->z_q16;
    const uint32_t mean = (uint32_t)(sum >> 16) / 3; /* (2^32 - 1) / 2^16 at most */

    return (uint16_t)(mean * (uint32_t)o->buckets >> 16);
}

static void keep(struct etch_sink *sink, const struct etch_vertex *const v[3])
{
    /* sink is the first member, so it has the address of the whole */
    struct etch_ordering *const o = (struct etch_ordering *)(void *)sink;
    struct etch_ordered *const t = &o->triangle[o->count];
    uint16_t *last;

    if (o->count == o->room) {
        o->lost = (uint16_t)(o->lost + (o->lost != UINT16_MAX));
        return;
    }
    last = &o->bucket[place(o, v)];
    t->v[0] = *v[0], t->v[1] = *v[1], t->v[2] = *v[2];
    t->next = o->count;
    if (*last != ETCH_ORDERING_NONE) {
        t->next = o->triangle[*last].next;
        o->triangle[*last].next = o->count;
    }
    *last = o->count++;
}

void etch_ordering_init(struct etch_ordering *o, struct etch_ordered *triangle, uint16_t room,
                        uint16_t *bucket, uint16_t buckets)
{
    const struct etch_sink sink = {.triangle = keep};

    o->sink = sink;
    o->triangle = triangle;
    o->bucket = bucket;
    o->buckets = buckets;
    o->room = room;
    o->count = o->lost = 0;
    for (uint16_t i = 0; i < buckets; i++)
        bucket[i] = ETCH_ORDERING_NONE;
}

void etch_ordering_draw(const struct etch_ordering *o, struct etch_sink *to)
{
    for (uint16_t i = o->buckets; i != 0; i--) {
        const uint16_t last = o->bucket[i - 1];
        uint16_t at = last;

        if (last == ETCH_ORDERING_NONE)
            continue;
        do {
            const struct etch_vertex *const v = o->triangle[at = o->triangle[at].next].v;
            const struct etch_vertex *const corner[3] = {&v[0], &v[1], &v[2]};

            to->triangle(to, corner);
        } while (at != last);
    }
}
