/* ports/tools/image_no_png.c: stands for image_png.c where there is no libpng. See image_source.h.
 */
#include "image_source.h"

void image_read_png(struct picture *p, FILE *file, const char *path)
{
    (void)p;
    (void)file;
    image_fail("built without libpng (libpng-dev), so it reads PPM and PGM only: ", path);
}
