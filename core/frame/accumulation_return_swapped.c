/* frame/accumulation_return_swapped.c: sums of frames to pixels in the order of most panels.
 * Called by applications, once a strip. See accumulation.h. */
#include "accumulation_divide.h"

void etch_accumulation_return_swapped(const struct etch_accumulation *a,
                                      const struct etch_surface *s, uint16_t divisor)
{
    accumulation_divide(a, s, divisor, true);
}
