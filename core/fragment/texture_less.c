/* fragment/texture_less.c: affine texture where nearer than the depth plane. See texture.h. */
#include "texture_rows.h"

ETCH_TEXTURE_KERNEL(etch_kernel_texture_less, etch_depth_less)
