/* fragment/flat_small.h: the kernels of flat.h for programs that count bytes. Same pixels. */
#ifndef ETCH_FRAGMENT_FLAT_SMALL_H
#define ETCH_FRAGMENT_FLAT_SMALL_H

#include "flat.h"

/* As etch_kernel_flat, with the same paint; 4 instructions a pixel on ARMv6-M. */
etch_kernel etch_kernel_flat_small;

#endif
