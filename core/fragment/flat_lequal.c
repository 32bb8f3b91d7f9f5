/* fragment/flat_lequal.c: one colour where not farther than the depth plane. See flat.h. */
#include "flat_shader.h"

ETCH_KERNEL(etch_kernel_flat_lequal, etch_flat_shader, etch_depth_lequal, true)
