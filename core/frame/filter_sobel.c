/* frame/filter_sobel.c: how much a picture changes at a pixel. Called by applications, once a
 * strip. See filter.h. */
#include "filter_kernel.h"

void etch_filter_sobel(struct etch_carry *c, const struct etch_surface *source,
                       const struct etch_surface *strip)
{
    filter_walk(c, source, strip, NULL, filter_edges, false);
}
