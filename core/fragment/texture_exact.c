/* fragment/texture_exact.c: texture in perspective, a divide every pixel, without depth. See
 * texture.h. */
#include "texture_exact.h"

ETCH_KERNEL(etch_kernel_perspective_exact, etch_perspective_shader, NULL, false)
