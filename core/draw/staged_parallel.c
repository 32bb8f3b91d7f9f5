/* draw/staged_parallel.c: whether a triangle is seen without perspective. Called by those who
 * choose between two pipelines. See staged.h. */
#include "staged.h"

static uint32_t distance(const struct etch_texture_vertex *v)
{
    return v->w != 0 ? v->w : 1;
}

bool etch_triangle_is_parallel(const struct etch_texture_vertex *const v[3])
{
    return distance(v[0]) == distance(v[1]) && distance(v[0]) == distance(v[2]);
}
