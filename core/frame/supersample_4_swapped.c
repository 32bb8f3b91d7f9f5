/* frame/supersample_4_swapped.c: 4 x 4 samples to pixels in the order of most panels. Called by
 * applications, once a strip. See supersample.h. */
#include "supersample_rows.h"

void etch_supersample_resolve_4_swapped(const struct etch_surface *large,
                                        const struct etch_surface *out)
{
    supersample_resolve(large, out, 4, true);
}
