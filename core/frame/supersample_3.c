/* frame/supersample_3.c: 3 x 3 samples to pixels. Called by applications, once a strip. See
 * supersample.h. */
#include "supersample_rows.h"

void etch_supersample_resolve_3(const struct etch_surface *large, const struct etch_surface *out)
{
    supersample_resolve(large, out, 3, false);
}
