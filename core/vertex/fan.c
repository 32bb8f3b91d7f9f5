/* vertex/fan.c: a projected polygon to triangles. Called by assembly.c and varying.c. See fan.h and
 * etch_assemble_fan (assembly.h). */
#include "fan.h"

static void emit(const struct etch_assembly *assembly, const struct etch_vertex *const v[3])
{
    if (etch_cull_keeps(assembly->cull, v))
        assembly->sink->triangle(assembly->sink, v);
}

/* Sign of the polygon's area: +1 clockwise as seen. */
static int8_t polygon_winding(const struct etch_vertex *const *v, uint8_t n)
{
    int64_t area = 0;

    for (uint8_t i = 1; i + 1 < n; i++)
        area += etch_mul_s32(v[i]->x_q8 - v[0]->x_q8, v[i + 1]->y_q8 - v[0]->y_q8) -
                etch_mul_s32(v[i + 1]->x_q8 - v[0]->x_q8, v[i]->y_q8 - v[0]->y_q8);
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

/* Cuts ears off until a triangle is left. A convex polygon becomes the fan round its first corner.
 */
void etch_fan_emit(const struct etch_assembly *assembly, const struct etch_vertex **ring, uint8_t n)
{
    const int8_t winding = polygon_winding(ring, n);

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
