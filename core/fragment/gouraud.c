/* fragment/gouraud.c: interpolated colour. See gouraud.h. */
#include "gouraud_shader.h"

ETCH_KERNEL(etch_kernel_gouraud, etch_gouraud_shader, NULL, false)
