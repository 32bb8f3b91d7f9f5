/* draw/texture_perspective_lequal.c: one way to draw in perspective. See texture.h. */
#include "../fragment/texture.h"
#include "texture.h"

const struct etch_perspective_kernels etch_perspective_lequal = {
    etch_kernel_texture_lequal, etch_kernel_perspective_lequal,
    etch_kernel_perspective_exact_lequal};
