/* vertex/assembly.c: clip-space triangles to the sink. Called by draw/mesh for triangles that
 * need clipping, and by applications that have clip-space vertices. See assembly.h. */
#include "assembly.h"

static void emit(const struct etch_assembly *assembly, const struct etch_vertex *const v[3])
{
    if (etch_cull_keeps(assembly->cull, v))
        assembly->sink->triangle(assembly->sink, v);
}

/* Sign of the polygon's area: +1 clockwise as seen. */
static int8_t polygon_winding(const struct etch_vertex *v, uint8_t n)
{
    int64_t area = 0;

    for (uint8_t i = 1; i + 1 < n; i++)
        area += etch_mul_s32(v[i].x_q8 - v[0].x_q8, v[i + 1].y_q8 - v[0].y_q8) -
                etch_mul_s32(v[i + 1].x_q8 - v[0].x_q8, v[i].y_q8 - v[0].y_q8);
    return (int8_t)((area > 0) - (area < 0));
}

static bool is_inside(const struct etch_vertex *const t[3], const struct etch_vertex *p,
                      int8_t winding)
{
    for (uint8_t i = 0; i < 3; i++) {
        const struct etch_vertex *const edge[3] = {t[i], t[i < 2 ? i + 1 : 0], p};

        if (etch_winding(edge) != winding)
            return false;
    }
    return true;
}

/* Whether the corner ring[i] can be cut off: it turns the polygon's way, or not at all, and no
 * other vertex lies in its triangle, which is left in t. */
static bool is_ear(const struct etch_vertex *t[3], const struct etch_vertex *const *ring, uint8_t n,
                   uint8_t i, int8_t winding)
{
    int8_t turn;

    t[0] = ring[i > 0 ? i - 1 : n - 1];
    t[1] = ring[i];
    t[2] = ring[i + 1 < n ? i + 1 : 0];
    turn = etch_winding(t);
    if (turn != winding)
        return turn == 0;
    for (uint8_t k = 0; k < n; k++)
        if (is_inside(t, ring[k], winding))
            return false;
    return true;
}

/* Cuts ears off until a triangle is left. A convex polygon becomes the fan round v[0]. */
void etch_assemble_fan(const struct etch_assembly *assembly, const struct etch_clip_vertex *v,
                       uint8_t n)
{
    struct etch_vertex projected[ETCH_CLIP_MAX];
    const struct etch_vertex *ring[ETCH_CLIP_MAX];

    for (uint8_t i = 0; i < n; i++) {
        etch_viewport_project(&assembly->viewport, &v[i], &projected[i]);
        ring[i] = &projected[i];
    }

    const int8_t winding = polygon_winding(projected, n);

    for (; n > 3; n--) {
        const struct etch_vertex *t[3];
        uint8_t i = 1;

        while (i < n && !is_ear(t, ring, n, i, winding))
            i++;
        if (i == n) /* the ear is at ring[0]: a simple polygon has two */
            is_ear(t, ring, n, i = 0, winding);
        if (etch_winding(t) == winding) /* not a fold of an outline that crosses itself */
            emit(assembly, t);
        for (; i + 1 < n; i++)
            ring[i] = ring[i + 1];
    }
    if (n == 3 && etch_winding(ring) == winding)
        emit(assembly, ring);
}

static void copy_color(struct etch_clip_vertex *to, const struct etch_clip_vertex *from)
{
    to->r = from->r;
    to->g = from->g;
    to->b = from->b;
    to->a = from->a;
}

void etch_assemble_triangle(const struct etch_assembly *assembly,
                            const struct etch_clip_vertex v[3])
{
    struct etch_clip_vertex polygon[ETCH_CLIP_MAX] = {v[0], v[1], v[2]};
    uint8_t all = ETCH_OUT_REJECT, any = 0, n = 3;

    for (int i = 0; i < 3; i++) {
        const uint8_t out = etch_viewport_outcode(&assembly->viewport, &v[i]);

        all &= out;
        any |= out;
    }
    if (all != 0)
        return;
    if (assembly->flat) {
        copy_color(&polygon[1], &polygon[0]);
        copy_color(&polygon[2], &polygon[0]);
    }
    if ((any & ETCH_OUT_CLIP) != 0) {
        const struct etch_clip_vertex t[3] = {polygon[0], polygon[1], polygon[2]};

        n = etch_clip_triangle(&assembly->viewport, t, polygon);
    }
    etch_assemble_fan(assembly, polygon, n);
}
