/* fragment/gouraud_swapped.c: interpolated colour, bytes swapped. See gouraud.h. */
#include "gouraud_shader.h"

ETCH_KERNEL(etch_kernel_gouraud_swapped, etch_gouraud_swapped_shader, NULL, false)
