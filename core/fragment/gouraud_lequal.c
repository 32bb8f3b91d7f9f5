/* fragment/gouraud_lequal.c: interpolated colour where not farther than the depth plane.
 * See gouraud.h. */
#include "gouraud_shader.h"

ETCH_KERNEL(etch_kernel_gouraud_lequal, etch_gouraud_shader, etch_depth_lequal, true)
