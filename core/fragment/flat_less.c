/* fragment/flat_less.c: one colour where nearer than the depth plane. See flat.h. */
#include "flat_shader.h"

ETCH_KERNEL(etch_kernel_flat_less, etch_flat_shader, etch_depth_less, true)
