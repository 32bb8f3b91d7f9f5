/* fragment/texture_perspective_less.c: texture in perspective, a divide every 16 pixels, where
 * nearer than the depth plane. See texture.h. */
#include "texture_block.h"

ETCH_PERSPECTIVE_KERNEL(etch_kernel_perspective_less, etch_depth_less)
