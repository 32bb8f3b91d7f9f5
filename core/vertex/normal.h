/* vertex/normal.h: normals through a model matrix, by its inverse transpose: right for scales that
 * differ by axis, shears and mirrors, where the matrix itself would tilt them. */
#ifndef ETCH_VERTEX_NORMAL_H
#define ETCH_VERTEX_NORMAL_H

#include "../base/unit.h"
#include "matrix.h"

/* The inverse transpose of a matrix's 3x3 part times a positive factor. */
struct etch_normal_matrix {
    int16_t m[3][3]; /* the largest entry's magnitude is 2^13 .. 2^14 */
};

/* Entries err by less than 1 unit from the exact ones. A matrix that flattens space to a plane
 * gives that plane's normal; one that leaves a line or a point ETCH_EINVAL, *n is then as it was.
 * Once per draw. */
enum etch_status etch_normal_matrix_init(struct etch_normal_matrix *n,
                                         const struct etch_matrix *model);

/* The unit normal in 2.14, within 2 units a component of the one that the entries give; zero for a
 * normal that becomes zero. 9 products and etch_unit_q14. */
void etch_normal_transform(const struct etch_normal_matrix *n, const int8_t normal[3],
                           int16_t unit[3]);

#endif
