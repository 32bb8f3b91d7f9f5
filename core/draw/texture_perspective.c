/* draw/texture_perspective.c: one way to draw in perspective. See texture.h. */
#include "../fragment/texture.h"
#include "texture.h"

const struct etch_perspective_kernels etch_perspective = {
    etch_kernel_texture, etch_kernel_perspective, etch_kernel_perspective_exact};
