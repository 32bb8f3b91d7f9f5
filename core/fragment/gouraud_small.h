/* fragment/gouraud_small.h: the kernels of gouraud.h for programs that count bytes. Same paint,
 * same pixels. */
#ifndef ETCH_FRAGMENT_GOURAUD_SMALL_H
#define ETCH_FRAGMENT_GOURAUD_SMALL_H

#include "gouraud.h"

etch_kernel etch_kernel_gouraud_small;      /* as etch_kernel_gouraud */
etch_kernel etch_kernel_gouraud_less_small; /* as etch_kernel_gouraud_less */

#endif
