/* draw/row_mask4_swapped.c: a colour by a mask of 4 bits, byte-swapped. Called for each row of an
 * image. See image.h. */
#include "image_row.h"

ETCH_ROW_BLEND(etch_row_mask4_swapped, etch_texel_ink, etch_texel_mask4, true)
