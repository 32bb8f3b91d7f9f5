/* fragment/texture_lequal.c: affine texture where not farther than the depth plane. See
 * texture.h. */
#include "texture_rows.h"

ETCH_TEXTURE_KERNEL(etch_kernel_texture_lequal, etch_depth_lequal)
