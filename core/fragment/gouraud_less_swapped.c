/* fragment/gouraud_less_swapped.c: interpolated colour where nearer, bytes swapped.
 * See gouraud.h. */
#include "gouraud_shader.h"

ETCH_KERNEL(etch_kernel_gouraud_less_swapped, etch_gouraud_swapped_shader, etch_depth_less, true)
