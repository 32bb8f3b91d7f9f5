/* vertex/rotate_small.h: rotation for programs that count bytes. */
#ifndef ETCH_VERTEX_ROTATE_SMALL_H
#define ETCH_VERTEX_ROTATE_SMALL_H

#include "matrix.h"

/* As etch_matrix_rotate_y (matrix.h); entries err by up to 2^-11. Exact at quarter turns. */
void etch_matrix_rotate_y_small(struct etch_matrix *m, uint16_t angle);

#endif
