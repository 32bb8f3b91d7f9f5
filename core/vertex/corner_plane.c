/* vertex/corner_plane.c: corners of a triangle by the names of their two lines. Called by
 * corner_clip.c, clip.c, clip_volume.c, assembly.c and varying.c. See corner.h; corner.c does the
 * arithmetic. */
#include "corner.h"

struct corner etch_corner_vertex(uint8_t i)
{
    const uint8_t next = (uint8_t)(i < 2 ? i + 1 : 0);
    const struct corner c = {{next, (uint8_t)(3 - i - next)}};

    return c;
}

int8_t etch_corner_which(const struct corner *c)
{
    const bool is_vertex = c->line[0] < CORNER_EDGES && c->line[1] < CORNER_EDGES;

    return (int8_t)(is_vertex ? CORNER_EDGES - c->line[0] - c->line[1] : -1);
}

/* Of plane i distances of the triangle's vertices: near w + z, far w - z, then 2^guard w + x,
 * 2^guard w - x and the same with y. At most 2^41 + 2^31. */
void etch_corner_line(struct corner_line *line, const struct corner_triangle *t, uint8_t name)
{
    const uint8_t i = (uint8_t)(name - CORNER_EDGES);
    const uint8_t shift = i < 2 ? 0 : i < 4 ? t->guard_x : t->guard_y;

    for (uint8_t j = 0; j < 3; j++) {
        const struct etch_clip_vertex *const v = t->v[j];
        const int64_t axis = i < 2 ? v->z : i < 4 ? v->x : v->y;

        line->at[j] = name < CORNER_EDGES
                          ? name == j
                          : v->w * (INT64_C(1) << shift) + ((i & 1) != 0 ? -axis : axis);
    }
}

void etch_corner_weights(struct corner_weights *weights, const struct corner_triangle *t,
                         const struct corner *corner)
{
    struct corner_line a, b;

    etch_corner_line(&a, t, corner->line[0]);
    etch_corner_line(&b, t, corner->line[1]);
    etch_corner_meet(weights, &a, &b);
}

bool etch_corner_is_in_plane(const struct corner_triangle *t, const struct corner *corner,
                             const struct corner_line *plane)
{
    const int8_t which = etch_corner_which(corner);
    struct corner_weights weights;

    if (which >= 0)
        return plane->at[which] >= 0;
    etch_corner_weights(&weights, t, corner);
    return etch_corner_is_inside(&weights, plane);
}

void etch_corner_take(struct etch_clip_vertex *out, const struct corner_triangle *t,
                      const struct corner *corner)
{
    const int8_t which = etch_corner_which(corner);
    struct corner_weights weights;

    if (which >= 0) {
        *out = *t->v[which];
        return;
    }
    etch_corner_weights(&weights, t, corner);
    etch_corner_resolve(out, &weights, t->v);
}
