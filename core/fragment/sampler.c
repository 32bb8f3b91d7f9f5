/* fragment/sampler.c: checks what a sampler is made of. Called by applications. See sampler.h. */
#include "sampler.h"

enum etch_status etch_sampler_init(struct etch_sampler *s, const struct etch_image *image,
                                   etch_texel_filter *filter, etch_texel_wrap *wrap)
{
    if (!etch_image_valid(image) || filter == NULL || wrap == NULL)
        return ETCH_EINVAL;
    s->image = *image;
    s->filter = filter;
    s->wrap_u = wrap;
    s->wrap_v = wrap;
    return ETCH_OK;
}
