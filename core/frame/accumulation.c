/* frame/accumulation.c: making accumulation planes. Called by applications, once a strip. See
 * accumulation.h. */
#include "accumulation.h"

enum etch_status etch_accumulation_init(struct etch_accumulation *a, uint16_t *sums,
                                        struct etch_rect window, uint16_t stride)
{
    ETCH_ASSERT(a != NULL && ((uintptr_t)sums & 1) == 0);
    if (sums == NULL || etch_rect_is_empty(window) || window.x0 < 0 || window.y0 < 0 ||
        stride < (uint16_t)(window.x1 - window.x0))
        return ETCH_EINVAL;
    a->sums = sums;
    a->stride = stride;
    a->window = window;
    return ETCH_OK;
}
