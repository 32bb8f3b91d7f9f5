/* fragment/inverse_rows_lequal.c: depths in a floating layout, where not farther. Called by the
 * kernels of inverse.h. */
#include "inverse_rows.h"

void etch_inverse_rows_lequal(const struct etch_surface *surface, int16_t y0,
                              const struct etch_run *runs, uint8_t n,
                              const struct etch_paint *paint, uint8_t up, etch_span *span)
{
    inverse_rows(surface, y0, runs, n, paint, up, span, etch_depth_lequal);
}
