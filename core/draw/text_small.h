/* draw/text_small.h: a glyph painter for programs that count bytes. */
#ifndef ETCH_DRAW_TEXT_SMALL_H
#define ETCH_DRAW_TEXT_SMALL_H

#include "text.h"

/* The pixels of etch_glyph_solid, one by one: some 11 instructions for each pixel of a bitmap. */
etch_glyph_painter etch_glyph_solid_small;

#endif
