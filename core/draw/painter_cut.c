/* draw/painter_cut.c: cuts a triangle along the plane of another. Called by painter_sort.c. See
 * painter.h. */
#include "painter_steps.h"

#define LIMIT (INT32_C(1) << 23) /* of coordinates */

/* Where the edge a, b meets the plane: t = |da| / (|da| + |db|) in 2.30. */
static uint32_t meeting(struct etch_painter_distance a, struct etch_painter_distance b)
{
    const int64_t limit = INT64_C(1) << 33;
    uint64_t da, db;

    if (a.high < 0) /* -a: a borrow from the lower part, which is left as all ones less 2^-28 */
        a.high = -a.high - 1, a.low = (UINT32_C(1) << 28) - 1 - a.low;
    if (b.high < 0)
        b.high = -b.high - 1, b.low = (UINT32_C(1) << 28) - 1 - b.low;
    if (a.high < limit && b.high < limit) {
        da = (uint64_t)a.high << 28 | a.low;
        db = (uint64_t)b.high << 28 | b.low;
    } else {
        da = (uint64_t)a.high;
        db = (uint64_t)b.high;
    }
    while (da + db >= UINT64_C(1) << 32)
        da >>= 1, db >>= 1;
    return da + db == 0 ? 0 : (uint32_t)etch_divide_u64(da << 30, da + db).quotient;
}

/* a + t (b - a), rounded half up. */
static int64_t between(int64_t a, int64_t b, uint32_t t)
{
    return a + (((b - a) * (int64_t)t + (INT64_C(1) << 29)) >> 30);
}

/* The one of four points round (x, y) in 1/256 px, x and y to be rounded down, that is on the edge
 * a, b or the least outside it, seen from c within. */
static void move_out(struct etch_vertex *v, const struct etch_vertex *a,
                     const struct etch_vertex *b, const struct etch_vertex *c)
{
    const bool clockwise = etch_painter_turn(a, b, c) > 0;
    struct etch_vertex best = *v;
    int64_t least = INT64_MAX;

    for (uint8_t i = 0; i < 4; i++) {
        struct etch_vertex to = *v;
        int64_t out;

        to.x_q8 += (i & 1) != 0 && v->x_q8 < LIMIT;
        to.y_q8 += i > 1 && v->y_q8 < LIMIT;
        out = etch_painter_turn(a, b, &to);
        out = clockwise ? -out : out;
        if (out < 0) /* inside: only if all are, and then the outermost */
            out = (INT64_C(1) << 60) - out;
        if (out < least) {
            least = out;
            best = to;
        }
    }
    *v = best;
}

/* The vertex where the edge a, b of the triangle with c meets the plane. From the left or upper
 * end, so that neighbours find the same. */
static struct etch_vertex meet(const struct etch_painter_plane *plane, const struct etch_vertex *a,
                               const struct etch_vertex *b, const struct etch_vertex *c)
{
    struct etch_vertex v;
    uint32_t t;

    if (b->y_q8 < a->y_q8 || (b->y_q8 == a->y_q8 && b->x_q8 < a->x_q8)) {
        const struct etch_vertex *const other = a;

        a = b, b = other;
    }
    t = meeting(etch_painter_distance(plane, a), etch_painter_distance(plane, b));
    v.x_q8 = a->x_q8 + (int32_t)((int64_t)(b->x_q8 - a->x_q8) * t >> 30);
    v.y_q8 = a->y_q8 + (int32_t)((int64_t)(b->y_q8 - a->y_q8) * t >> 30);
    v.z_q16 = (uint32_t)between((int64_t)a->z_q16, (int64_t)b->z_q16, t);
    v.r = (uint8_t)between(a->r, b->r, t);
    v.g = (uint8_t)between(a->g, b->g, t);
    v.b = (uint8_t)between(a->b, b->b, t);
    v.a = (uint8_t)between(a->a, b->a, t);
    move_out(&v, a, b, c);
    return v;
}

/* The part of the triangle whose vertices are on the plane or on `keep` of it: 3 or 4 vertices. */
static uint8_t part(struct etch_vertex out[4], const struct etch_painter_plane *plane,
                    const struct etch_vertex v[3], const int8_t side[3], int8_t keep)
{
    uint8_t n = 0;

    for (uint8_t i = 0; i < 3; i++) {
        const uint8_t next = (uint8_t)(i < 2 ? i + 1 : 0), third = (uint8_t)(i > 0 ? i - 1 : 2);

        if (side[i] != -keep)
            out[n++] = v[i];
        if (side[i] * side[next] < 0)
            out[n++] = meet(plane, &v[i], &v[next], &v[third]);
    }
    return n;
}

/* Adds the triangles of a part to list[0 .. *n - 1]. */
static void fan(struct etch_painter_triangle *list, uint8_t *n, const struct etch_vertex *v,
                uint8_t corners)
{
    for (uint8_t i = 2; i < corners; i++) {
        const struct etch_vertex corner[3] = {v[0], v[i - 1], v[i]};

        if (etch_painter_take(&list[*n], corner))
            ++*n;
    }
}

enum etch_painter_cut etch_painter_cut(struct etch_painter *p, uint16_t at, uint16_t by,
                                       uint16_t piece[3], uint8_t *n)
{
    const uint16_t whole = p->triangle[at].whole;
    const struct etch_vertex *const v = p->triangle[at].v;
    struct etch_painter_triangle list[3];
    struct etch_painter_plane plane;
    struct etch_vertex corner[4];
    int8_t side[3];
    uint8_t i;

    etch_painter_plane_setup(&plane, p->triangle[p->triangle[by].whole].v);
    for (i = 0; i < 3; i++)
        side[i] = etch_painter_side(&plane, &v[i]);
    if (side[0] * side[1] >= 0 && side[1] * side[2] >= 0 && side[2] * side[0] >= 0)
        return ETCH_PAINTER_WHOLE;
    *n = 0;
    fan(list, n, corner, part(corner, &plane, v, side, 1));
    fan(list, n, corner, part(corner, &plane, v, side, -1));
    if ((uint16_t)(p->room - p->count) < (uint16_t)(*n - (at != whole))) {
        p->uncut = true;
        return ETCH_PAINTER_FULL;
    }
    for (i = 0; i < *n; i++) { /* a piece gives its place to one of its own */
        piece[i] = i == 0 && at != whole ? at : p->count++;
        list[i].whole = whole;
        p->triangle[piece[i]] = list[i];
    }
    return ETCH_PAINTER_CUT;
}
