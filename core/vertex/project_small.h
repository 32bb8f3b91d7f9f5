/* vertex/project_small.h: projection for programs that count bytes. */
#ifndef ETCH_VERTEX_PROJECT_SMALL_H
#define ETCH_VERTEX_PROJECT_SMALL_H

#include "viewport.h"

/* floor(n / d) where that is below 2^32, d not 0; 32 steps of shift and subtract. */
uint32_t etch_divide_small(uint64_t n, uint32_t d);

/* What etch_viewport_project (viewport.h) gives, to the last bit, by three divisions of 350
 * instructions on ARMv6-M. */
void etch_viewport_project_small(const struct etch_viewport *v, const struct etch_clip_vertex *in,
                                 struct etch_vertex *out);

#endif
