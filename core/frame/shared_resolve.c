/* frame/shared_resolve.c: samples that neighbours share to pixels. Called by applications, once a
 * strip. See shared.h. */
#include "multisample_average.h"
#include "shared.h"

/* The cells of a pixel are its own and the next. */
void etch_shared_resolve(const struct etch_shared_samples *m, const struct etch_surface *out)
{
    const uint16_t *const first = m->sample[0].pixels, *const second = m->sample[1].pixels;
    const uint16_t *const plane[4] = {first, second, first + 1, second + 1};
    struct etch_rect pixels = m->sample[0].window;

    pixels.x1--;
    multisample_average(plane, &m->sample[0], out, etch_rect_intersect(pixels, out->clip), false);
}
