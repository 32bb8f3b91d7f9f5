/* frame/accumulation_return.c: sums of frames to pixels. Called by applications, once a strip. See
 * accumulation.h. */
#include "accumulation_divide.h"

void etch_accumulation_return(const struct etch_accumulation *a, const struct etch_surface *s,
                              uint16_t divisor)
{
    accumulation_divide(a, s, divisor, false);
}
