/* fragment/blend_flat_swapped.c: one colour and alpha over the pixels, bytes swapped. See
 * blend_fused.h. */
#include "blend_flat_shader.h"

ETCH_BLEND_KERNEL(etch_kernel_flat_blend_swapped, etch_flat_blender_swapped)
