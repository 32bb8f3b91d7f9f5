/* frame/supersample_4.c: 4 x 4 samples to pixels. Called by applications, once a strip. See
 * supersample.h. */
#include "supersample_rows.h"

void etch_supersample_resolve_4(const struct etch_surface *large, const struct etch_surface *out)
{
    supersample_resolve(large, out, 4, false);
}
