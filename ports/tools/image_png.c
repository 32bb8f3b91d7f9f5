/* ports/tools/image_png.c: reads PNG by libpng's simplified API for etch-image. See image_source.h.
 */
#include <png.h>
#include <string.h>

#include "image_source.h"

void image_read_png(struct picture *p, FILE *file, const char *path)
{
    png_image image;

    memset(&image, 0, sizeof image);
    image.version = PNG_IMAGE_VERSION;
    rewind(file);
    if (png_image_begin_read_from_stdio(&image, file) == 0)
        image_fail(image.message[0] != '\0' ? "PNG is damaged: " : "not a PNG: ", path);
    const bool alpha = (image.format & PNG_FORMAT_FLAG_ALPHA) != 0;

    image.format = PNG_FORMAT_RGBA;
    image_open(p, (long)image.width, (long)image.height, path);
    p->alpha = alpha;
    if (png_image_finish_read(&image, NULL, p->rgba, 0, NULL) == 0)
        image_fail("PNG is damaged: ", path);
}
