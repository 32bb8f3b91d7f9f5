/* fragment/texture_exact_less.c: texture in perspective, a divide every pixel, where nearer than
 * the depth plane. See texture.h. */
#include "texture_exact.h"

ETCH_KERNEL(etch_kernel_perspective_exact_less, etch_perspective_shader, etch_depth_less, true)
