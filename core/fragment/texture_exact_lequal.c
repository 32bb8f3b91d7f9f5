/* fragment/texture_exact_lequal.c: texture in perspective, a divide every pixel, where not farther
 * than the depth plane. See texture.h. */
#include "texture_exact.h"

ETCH_KERNEL(etch_kernel_perspective_exact_lequal, etch_perspective_shader, etch_depth_lequal, true)
