/* draw/painter_steps.h: the parts of the painter's algorithm; no part of the API. */
#ifndef ETCH_DRAW_PAINTER_STEPS_H
#define ETCH_DRAW_PAINTER_STEPS_H

#include "painter.h"

/* Twice the area of a, b, c on the screen, positive if clockwise as seen. Below 2^50. */
ETCH_INLINE int64_t etch_painter_turn(const struct etch_vertex *a, const struct etch_vertex *b,
                                      const struct etch_vertex *c)
{
    return etch_mul_s32(b->x_q8 - a->x_q8, c->y_q8 - a->y_q8) -
           etch_mul_s32(b->y_q8 - a->y_q8, c->x_q8 - a->x_q8);
}

/* Sets the vertices and depths of a triangle that was not moved; false if it has no area. */
bool etch_painter_take(struct etch_painter_triangle *t, const struct etch_vertex v[3]);

/* ---- planes: painter_plane.c ----------------------------------------------------------------- */

/* The plane through a triangle, nx x + ny y + nz z = const. nx, ny below 2^57, nz 1 .. 2^49. */
struct etch_painter_plane {
    int64_t nx, ny, nz;
    int64_t near; /* 2 |nx| + 2 |ny| + 16 nz: what is no further off is on it */
    struct etch_vertex at;
};

/* A distance from a plane, high 2^28 + low, 0 <= low < 2^28; positive is behind it. */
struct etch_painter_distance {
    int64_t high;
    uint32_t low;
};

void etch_painter_plane_setup(struct etch_painter_plane *plane, const struct etch_vertex v[3]);

struct etch_painter_distance etch_painter_distance(const struct etch_painter_plane *plane,
                                                   const struct etch_vertex *v);

/* +1 behind the plane, -1 in front of it, 0 on it. */
int8_t etch_painter_side(const struct etch_painter_plane *plane, const struct etch_vertex *v);

/* ---- tests of two triangles: painter_test.c -------------------------------------------------- */

/* Whether `far` may be drawn before `near` as far as can be told from the screen alone: their
 * extents are apart. */
bool etch_painter_extents_apart(const struct etch_painter_triangle *a,
                                const struct etch_painter_triangle *b);

/* Whether no pixel can be in both. */
bool etch_painter_is_apart(const struct etch_painter_triangle *a,
                           const struct etch_painter_triangle *b);

/* Whether triangle `far` lies wholly behind the plane of `near`, or `near` in front of that of
 * `far`. */
bool etch_painter_is_behind(const struct etch_painter *p, uint16_t far, uint16_t near);

/* ---- cuts: painter_cut.c --------------------------------------------------------------------- */

enum etch_painter_cut {
    ETCH_PAINTER_WHOLE, /* the plane does not cut it */
    ETCH_PAINTER_FULL,  /* it would, but there is no room */
    ETCH_PAINTER_CUT
};

/* Cuts triangle `at` along the plane of triangle `by`; the pieces are piece[0 .. *n - 1], at most
 * three, in no list. */
enum etch_painter_cut etch_painter_cut(struct etch_painter *p, uint16_t at, uint16_t by,
                                       uint16_t piece[3], uint8_t *n);

#endif
