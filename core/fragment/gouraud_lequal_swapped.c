/* fragment/gouraud_lequal_swapped.c: interpolated colour where not farther, bytes swapped.
 * See gouraud.h. */
#include "gouraud_shader.h"

ETCH_KERNEL(etch_kernel_gouraud_lequal_swapped, etch_gouraud_swapped_shader, etch_depth_lequal,
            true)
