/* vertex/vector.h: directions, for matrices and lights. */
#ifndef ETCH_VERTEX_VECTOR_H
#define ETCH_VERTEX_VECTOR_H

#include "../base/fixed.h"

/* Shifts v left (exactly) or right (rounding down) until its largest magnitude is in 2^29 ..
 * 2^30 - 1. A zero vector stays. |v[i]| < 2^62. */
void etch_vector_normalize_range(int64_t v[3]);

/* The unit vector along v in 2.30; a component errs by less than 4 units of 2^-30 for |v[i]| <
 * 2^30, and by twice that where v has to be shortened first. ETCH_EINVAL for the zero vector,
 * unit[] is then unchanged. |v[i]| < 2^62. */
enum etch_status etch_vector_unit_q30(int32_t unit[3], const int64_t v[3]);

/* a x b of vectors with |component| <= 2^30: exact. */
void etch_vector_cross(int64_t cross[3], const int32_t a[3], const int32_t b[3]);

#endif
