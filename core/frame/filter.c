/* frame/filter.c: any 3 x 3 kernel. Called by applications, once a strip. See filter.h. */
#include "filter_kernel.h"

void etch_filter_draw(struct etch_carry *c, const struct etch_surface *source,
                      const struct etch_surface *strip, const struct etch_filter_weights *weights)
{
    const struct filter_scale scale = filter_scale(weights);

    filter_walk(c, source, strip, &scale, filter_any, false);
}
