/* fragment/blend_gouraud.c: interpolated colour and alpha over the pixels. See blend_fused.h. */
#include "blend_gouraud_shader.h"

static const struct etch_blender blender = {etch_gouraud_blend_start, etch_gouraud_blend_step,
                                            etch_gouraud_blend_color};
static const struct etch_blender swapped = {etch_gouraud_blend_start, etch_gouraud_blend_step,
                                            etch_gouraud_blend_color_swapped};

ETCH_BLEND_KERNEL(etch_kernel_gouraud_blend, blender)
ETCH_BLEND_KERNEL(etch_kernel_gouraud_blend_swapped, swapped)
