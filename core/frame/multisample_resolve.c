/* frame/multisample_resolve.c: four samples to pixels. Called by applications, once a strip. See
 * multisample.h. */
#include "multisample.h"
#include "multisample_average.h"

void etch_multisample_resolve(const struct etch_multisample *m, const struct etch_surface *out)
{
    const uint16_t *const plane[4] = {m->sample[0].pixels, m->sample[1].pixels, m->sample[2].pixels,
                                      m->sample[3].pixels};

    multisample_average(plane, &m->sample[0], out,
                        etch_rect_intersect(m->sample[0].window, out->clip), false);
}
