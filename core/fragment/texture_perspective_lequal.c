/* fragment/texture_perspective_lequal.c: texture in perspective, a divide every 16 pixels, where
 * not farther than the depth plane. See texture.h. */
#include "texture_block.h"

ETCH_PERSPECTIVE_KERNEL(etch_kernel_perspective_lequal, etch_depth_lequal)
