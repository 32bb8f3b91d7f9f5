/* vertex/matrix.h: 4x4 matrices in 16.16.
 *
 * Row-major, applied to column vectors: row i of m * (x, y, z, 1) is m[i][0] x + m[i][1] y +
 * m[i][2] z + m[i][3], and etch_matrix_multiply(&r, &a, &b) means "first b, then a". Spaces are
 * right-handed; the eye looks along -z with x to the right and y up, and the projections map
 * what it sees to the clip volume -w <= x, y, z <= w (near plane to z = -w).
 *
 * Every entry is rounded once to the nearest 1/65536 from exact products and quotients, unless
 * a function says otherwise. A function that returns a status leaves *m as it was on error:
 *   ETCH_EINVAL  a size of zero, near = far, ..: the transform does not exist;
 *   ETCH_ERANGE  an entry does not fit 16.16 (|entry| >= 32768; projections refuse the last
 *                unit before it too).
 */
#ifndef ETCH_VERTEX_MATRIX_H
#define ETCH_VERTEX_MATRIX_H

#include "../base/fixed.h"

struct etch_matrix {
    etch_q16 m[4][4];
};

struct etch_vector {
    etch_q16 x, y, z;
};

/* ---- building blocks ------------------------------------------------------------------ */

void etch_matrix_identity(struct etch_matrix *m);
void etch_matrix_translate(struct etch_matrix *m, etch_q16 x, etch_q16 y, etch_q16 z);
void etch_matrix_scale(struct etch_matrix *m, etch_q16 x, etch_q16 y, etch_q16 z);

/* m = a * b, "first b, then a". m may be a or b. ETCH_ERANGE. 64 widening multiplications. */
enum etch_status etch_matrix_multiply(struct etch_matrix *m, const struct etch_matrix *a,
                                      const struct etch_matrix *b);

/* ---- rotations: counter-clockwise for an eye at the axis' positive end ------------------ */

/* Exact at quarter turns; elsewhere entries err as etch_sin_q16 (base/trig.h). */
void etch_matrix_rotate_x(struct etch_matrix *m, uint16_t angle);
void etch_matrix_rotate_y(struct etch_matrix *m, uint16_t angle);
void etch_matrix_rotate_z(struct etch_matrix *m, uint16_t angle);

/* About `axis`, of any length but zero (ETCH_EINVAL). Entries err by less than 1/65536. */
enum etch_status etch_matrix_rotate(struct etch_matrix *m, uint16_t angle,
                                    const struct etch_vector *axis);

/* ---- the eye ---------------------------------------------------------------------------- */

/* World to eye space: the eye at `eye` looks at `target`, `up` is up on the screen. The 3x3
 * part errs by less than 1/65536 an entry, the last column is rounded from the exact product of
 * that part and `eye`. ETCH_EINVAL: eye = target, or up is zero or parallel to the view
 * (to 2^-26 of a radian; with coordinates beyond 8192 keep up 2^-10 away for the error above).
 * ETCH_ERANGE: the last column. */
enum etch_status etch_matrix_look_at(struct etch_matrix *m, const struct etch_vector *eye,
                                     const struct etch_vector *target,
                                     const struct etch_vector *up);

/* ---- projections: eye to clip space -------------------------------------------------------
 * near and far are distances before the eye, 0 < near < far (the orthographic ones may be
 * zero or negative, as long as near < far). */

/* `fov`: the vertical angle of view, 1 .. 32767 (half a turn is out of range); `aspect`: width
 * over height of the viewport, positive. The focal length, cot(fov / 2), errs by at most
 * 1/65536 + 2^-15 of its size; the rest is as below. */
enum etch_status etch_matrix_perspective(struct etch_matrix *m, uint16_t fov, etch_q16 aspect,
                                         etch_q16 near, etch_q16 far);

/* `focal`: distance of the screen in half screen heights, cot(fov / 2); positive. */
enum etch_status etch_matrix_perspective_focal(struct etch_matrix *m, etch_q16 focal,
                                               etch_q16 aspect, etch_q16 near, etch_q16 far);

/* The box left .. right, bottom .. top on the near plane; left != right, bottom != top. */
struct etch_box {
    etch_q16 left, right, bottom, top, near, far;
};

enum etch_status etch_matrix_frustum(struct etch_matrix *m, const struct etch_box *box);

/* Parallel projection of the box. */
enum etch_status etch_matrix_orthographic(struct etch_matrix *m, const struct etch_box *box);

#endif
