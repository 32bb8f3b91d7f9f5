/* frame/shared.c: making the surfaces of shared samples. Called by applications, once a strip. See
 * shared.h. */
#include "shared.h"

/* A cell's middle is the left edge of its pixel, 128 / 256 left of the centre. */
const struct etch_offset_q8 etch_shared_offsets[4] = {
    {-192, -96}, {-64, 32}, {-192, 96}, {-64, -32}};

enum etch_status etch_shared_init(struct etch_shared_samples *m, uint16_t *pixels, uint16_t *depth,
                                  struct etch_rect window)
{
    struct etch_rect cells = window;
    uint32_t size;

    if (pixels == NULL || etch_rect_is_empty(window) || window.x1 == INT16_MAX)
        return ETCH_EINVAL;
    cells.x1++;
    size = (uint32_t)(cells.x1 - cells.x0) * (uint32_t)(cells.y1 - cells.y0);
    for (uint8_t i = 0; i < ETCH_SHARED_SAMPLES; i++) {
        const enum etch_status status = etch_surface_init(&m->sample[i], pixels + i * size, cells,
                                                          (uint16_t)(cells.x1 - cells.x0));

        if (status != ETCH_OK)
            return status;
        m->sample[i].depth = depth == NULL ? NULL : depth + i * size;
    }
    return ETCH_OK;
}

void etch_shared_clip(struct etch_shared_samples *m, struct etch_rect clip)
{
    if (!etch_rect_is_empty(clip) && clip.x1 < INT16_MAX)
        clip.x1++;
    for (uint8_t i = 0; i < ETCH_SHARED_SAMPLES; i++)
        etch_surface_clip(&m->sample[i], clip);
}
