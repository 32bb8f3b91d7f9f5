/* fragment/blend_fade.c: interpolated colour with one alpha over the pixels. See blend_fused.h. */
#include "blend_gouraud_shader.h"

static const struct etch_blender blender = {etch_gouraud_fade_start, etch_gouraud_fade_step,
                                            etch_gouraud_fade_color};
static const struct etch_blender swapped = {etch_gouraud_fade_start, etch_gouraud_fade_step,
                                            etch_gouraud_fade_color_swapped};

ETCH_BLEND_KERNEL(etch_kernel_gouraud_fade, blender)
ETCH_BLEND_KERNEL(etch_kernel_gouraud_fade_swapped, swapped)
