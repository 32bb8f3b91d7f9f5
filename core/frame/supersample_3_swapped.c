/* frame/supersample_3_swapped.c: 3 x 3 samples to pixels in the order of most panels. Called by
 * applications, once a strip. See supersample.h. */
#include "supersample_rows.h"

void etch_supersample_resolve_3_swapped(const struct etch_surface *large,
                                        const struct etch_surface *out)
{
    supersample_resolve(large, out, 3, true);
}
