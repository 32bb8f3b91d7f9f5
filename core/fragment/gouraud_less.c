/* fragment/gouraud_less.c: interpolated colour where nearer than the depth plane. See gouraud.h. */
#include "gouraud_shader.h"

ETCH_KERNEL(etch_kernel_gouraud_less, etch_gouraud_shader, etch_depth_less, true)
