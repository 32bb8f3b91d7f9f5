/* base/image.c: checks what an image is made of. Called by what describes samplers and mipmaps. See
 * texture.h. */
#include "texture.h"

bool etch_image_valid(const struct etch_image *image)
{
    return image->colors != NULL && image->texels != NULL &&
           (image->alphas == NULL || image->alpha != NULL) && image->width >= 1 &&
           image->width <= 32767 && image->height >= 1 && image->height <= 32767 &&
           image->stride >= image->width;
}
