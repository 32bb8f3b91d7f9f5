/* fragment/blend_flat.c: one colour and alpha over the pixels. See blend_fused.h. */
#include "blend_flat_shader.h"

ETCH_BLEND_KERNEL(etch_kernel_flat_blend, etch_flat_blender)
