/* vertex/clip_volume.c: Sutherland-Hodgman as a pipeline of six planes. Called by
 * clip_volume_assembly.c and by applications. See clip_volume.h; corner_plane.c computes the
 * corners.
 *
 * A corner is where two lines of the triangle's plane meet, so two that follow each other have the
 * line between them in common, and that is what a stage cuts. */
#include "clip_volume.h"
#include "corner.h"

enum {
    EDGES = CORNER_EDGES,
    PLANES = CORNER_LINES - CORNER_EDGES
};

struct stage {
    bool any, first_inside, last_inside;
};

/* A corner on its way, and the line along which the outline comes to it. */
struct item {
    struct corner corner;
    uint8_t way, to; /* `to`: the stage that waits for it */
};

struct pipeline {
    struct corner_triangle t; /* without guard: the planes are those of the volume */
    struct stage stage[PLANES];
    struct etch_clip_vertex *out;
    uint8_t n;
};

/* Where the way meets the plane of stage i. From outside, the outline has come along the plane. */
static void cut(uint8_t i, uint8_t way, bool enters, struct item *out)
{
    out->corner = (struct corner){{way, (uint8_t)(EDGES + i)}};
    out->way = enters ? (uint8_t)(EDGES + i) : way;
    out->to = (uint8_t)(i + 1);
}

/* The end of the pipeline. A convex polygon never has more than ETCH_CLIP_MAX corners. */
static void finish(struct pipeline *p, const struct corner *c)
{
    if (p->n == ETCH_CLIP_MAX)
        return;
    etch_corner_take(&p->out[p->n++], &p->t, c);
}

/* One corner through stage i: 0 to 2 of them, the first last. */
static uint8_t pass(struct pipeline *p, uint8_t i, const struct item *in, struct item out[2])
{
    struct stage *const s = &p->stage[i];
    struct corner_line plane;
    uint8_t n = 0;

    etch_corner_line(&plane, &p->t, (uint8_t)(EDGES + i));
    const bool inside = etch_corner_is_in_plane(&p->t, &in->corner, &plane);

    if (inside) {
        out[n] = *in;
        out[n++].to = (uint8_t)(i + 1);
    }
    if (!s->any)
        s->first_inside = inside;
    else if (inside != s->last_inside)
        cut(i, in->way, inside, &out[n++]);
    s->any = true;
    s->last_inside = inside;
    return n;
}

/* Hands a corner on. Of two that a stage lets through the second waits: one for each stage. */
static void hand_on(struct pipeline *p, const struct item *first)
{
    struct item waiting[PLANES + 1];
    uint8_t n = 1;

    waiting[0] = *first;
    while (n != 0) {
        const struct item now = waiting[--n];

        if (now.to == PLANES)
            finish(p, &now.corner);
        else
            n = (uint8_t)(n + pass(p, now.to, &now, &waiting[n]));
    }
}

/* Stage after stage cuts the way back to its first corner, if that changes sides. Where the first
 * was outside, what follows the stage began with a cut, and ends along the plane. */
static void close(struct pipeline *p, uint8_t way)
{
    for (uint8_t i = 0; i < PLANES; i++) {
        const struct stage *const s = &p->stage[i];
        struct item c;

        if (s->any && s->first_inside != s->last_inside) {
            cut(i, way, s->first_inside, &c);
            hand_on(p, &c);
        }
        if (s->any && !s->first_inside)
            way = (uint8_t)(EDGES + i);
    }
}

uint8_t etch_clip_triangle_volume(const struct etch_clip_vertex v[3],
                                  struct etch_clip_vertex out[ETCH_CLIP_MAX])
{
    struct pipeline p;

    p.t = (struct corner_triangle){{&v[0], &v[1], &v[2]}, 0, 0};
    for (uint8_t i = 0; i < PLANES; i++)
        p.stage[i].any = false;
    p.out = out;
    p.n = 0;
    for (uint8_t i = 0; i < 3; i++) {
        struct item vertex;

        vertex.corner = etch_corner_vertex(i);
        vertex.way = (uint8_t)(i > 0 ? (i + 1) % 3 : 1);
        vertex.to = 0;
        hand_on(&p, &vertex);
    }
    close(&p, 1);
    for (uint8_t i = 0; i < p.n; i++)
        if (out[i].w <= 0) /* the eye itself: the triangle is seen edge-on */
            return 0;
    return p.n < 3 ? 0 : p.n;
}
