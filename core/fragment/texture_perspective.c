/* fragment/texture_perspective.c: texture in perspective, a divide every 16 pixels, without depth.
 * See texture.h. */
#include "texture_block.h"

ETCH_PERSPECTIVE_KERNEL(etch_kernel_perspective, NULL)
