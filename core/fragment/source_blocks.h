/* fragment/source_blocks.h: texture coordinates in perspective for less than a divide a pixel.
 *
 *      stage                               divides            error where the    instructions
 *                                                             coordinate curves  a pixel, M0+
 *                                                             by s texels/px^2
 *      etch_source_texture_perspective     every pixel        none (source.h)    163
 *      etch_source_texture_blocks8         every 8 pixels     8 s texels          64
 *      etch_source_texture_blocks16        every 16 pixels    32 s texels         51
 *      etch_source_texture                 none               affine              27
 *
 * Set up by etch_varying_texture_perspective (draw/staged.h). Coordinates are right where x is a
 * multiple of 8 or 16 of the frame, and linear between, held to the range of the vertices: strips
 * and clips change nothing. A triangle that etch_texture_perspective (raster/texture_plane.h) does
 * not find fit for blocks of 16 is divided at every pixel by all of them.
 */
#ifndef ETCH_FRAGMENT_SOURCE_BLOCKS_H
#define ETCH_FRAGMENT_SOURCE_BLOCKS_H

#include "source.h"

/* The coordinates of etch_kernel_perspective, bit for bit. */
etch_stage_function etch_source_texture_blocks16;

etch_stage_function etch_source_texture_blocks8;

#endif
