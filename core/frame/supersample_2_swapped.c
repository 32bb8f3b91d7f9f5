/* frame/supersample_2_swapped.c: 2 x 2 samples to pixels in the order of most panels. Called by
 * applications, once a strip. See supersample.h. */
#include "supersample_rows.h"

void etch_supersample_resolve_2_swapped(const struct etch_surface *large,
                                        const struct etch_surface *out)
{
    supersample_resolve(large, out, 2, true);
}
