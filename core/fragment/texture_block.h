/* fragment/texture_block.h: blocks of 16 columns, linear between their ends; no part of the API.
 *
 * Blocks begin at multiples of 16 of the frame, so that a pixel has the same coordinates whatever
 * run, clip or strip it is drawn in. A block without a pixel that passes costs no divide.
 */
#ifndef ETCH_FRAGMENT_TEXTURE_BLOCK_H
#define ETCH_FRAGMENT_TEXTURE_BLOCK_H

#include "texture_divide.h"

/* The paint is a struct etch_perspective_paint. */
etch_span etch_texel_blocks;

#endif
