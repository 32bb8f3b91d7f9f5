/* draw/painter_test.c: Newell's tests of two triangles. Called by painter_sort.c. See painter.h. */
#include "painter_steps.h"

/* Whether a, b, c are all at or beyond x, y, z. */
static bool beyond(int32_t a, int32_t b, int32_t c, int32_t x, int32_t y, int32_t z)
{
    const int32_t least = a < b ? a < c ? a : c : b < c ? b : c;

    return least >= x && least >= y && least >= z;
}

bool etch_painter_extents_apart(const struct etch_painter_triangle *a,
                                const struct etch_painter_triangle *b)
{
    const struct etch_vertex *const u = a->v, *const v = b->v;

    return beyond(u[0].x_q8, u[1].x_q8, u[2].x_q8, v[0].x_q8, v[1].x_q8, v[2].x_q8) ||
           beyond(v[0].x_q8, v[1].x_q8, v[2].x_q8, u[0].x_q8, u[1].x_q8, u[2].x_q8) ||
           beyond(u[0].y_q8, u[1].y_q8, u[2].y_q8, v[0].y_q8, v[1].y_q8, v[2].y_q8) ||
           beyond(v[0].y_q8, v[1].y_q8, v[2].y_q8, u[0].y_q8, u[1].y_q8, u[2].y_q8);
}

/* Whether an edge of a has all of b on its outside or on it. */
static bool is_separated(const struct etch_vertex a[3], const struct etch_vertex b[3])
{
    const bool clockwise = etch_painter_turn(&a[0], &a[1], &a[2]) > 0;

    for (uint8_t i = 0; i < 3; i++) {
        const struct etch_vertex *const from = &a[i], *const to = &a[i < 2 ? i + 1 : 0];
        uint8_t outside = 0;

        for (uint8_t k = 0; k < 3; k++) {
            const int64_t turn = etch_painter_turn(from, to, &b[k]);

            outside = (uint8_t)(outside + (clockwise ? turn <= 0 : turn >= 0));
        }
        if (outside == 3)
            return true;
    }
    return false;
}

bool etch_painter_is_apart(const struct etch_painter_triangle *a,
                           const struct etch_painter_triangle *b)
{
    return is_separated(a->v, b->v) || is_separated(b->v, a->v);
}

/* Whether no vertex of t is on the side of the plane of triangle `of` that is named. */
static bool has_none(const struct etch_painter *p, uint16_t of, uint16_t t, int8_t side)
{
    const struct etch_vertex *const v = p->triangle[t].v;
    struct etch_painter_plane plane;

    etch_painter_plane_setup(&plane, p->triangle[p->triangle[of].whole].v);
    return etch_painter_side(&plane, &v[0]) != side && etch_painter_side(&plane, &v[1]) != side &&
           etch_painter_side(&plane, &v[2]) != side;
}

bool etch_painter_is_behind(const struct etch_painter *p, uint16_t far, uint16_t near)
{
    return has_none(p, near, far, -1) || has_none(p, far, near, 1);
}
