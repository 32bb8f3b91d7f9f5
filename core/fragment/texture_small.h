/* fragment/texture_small.h: the kernel of texture.h for programs that count bytes. Same paint, same
 * pixels. */
#ifndef ETCH_FRAGMENT_TEXTURE_SMALL_H
#define ETCH_FRAGMENT_TEXTURE_SMALL_H

#include "texture.h"

etch_kernel etch_kernel_perspective_less_small; /* as etch_kernel_perspective_exact_less */

#endif
