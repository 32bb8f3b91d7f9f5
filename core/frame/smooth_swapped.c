/* frame/smooth_swapped.c: anti-aliasing of a finished picture in the order of most panels. Called
 * by applications, once a strip. See smooth.h. */
#include "smooth_rows.h"

void etch_smooth_draw_swapped(struct etch_carry *c, const struct etch_surface *source,
                              const struct etch_surface *strip)
{
    smooth_walk(c, source, strip, true);
}
