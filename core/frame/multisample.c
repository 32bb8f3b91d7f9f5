/* frame/multisample.c: making the surfaces of four samples. Called by applications, once a strip.
 * See multisample.h. */
#include "multisample.h"

enum etch_status etch_multisample_init(struct etch_multisample *m, uint16_t *pixels,
                                       uint16_t *depth, struct etch_rect window)
{
    uint32_t size;

    if (pixels == NULL || etch_rect_is_empty(window))
        return ETCH_EINVAL;
    size = (uint32_t)(window.x1 - window.x0) * (uint32_t)(window.y1 - window.y0);
    for (uint8_t i = 0; i < ETCH_SAMPLES; i++) {
        const enum etch_status status = etch_surface_init(&m->sample[i], pixels + i * size, window,
                                                          (uint16_t)(window.x1 - window.x0));

        if (status != ETCH_OK)
            return status;
        m->sample[i].depth = depth == NULL ? NULL : depth + i * size;
    }
    return ETCH_OK;
}

void etch_multisample_clip(struct etch_multisample *m, struct etch_rect clip)
{
    for (uint8_t i = 0; i < ETCH_SAMPLES; i++)
        etch_surface_clip(&m->sample[i], clip);
}
