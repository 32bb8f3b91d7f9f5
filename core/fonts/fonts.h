/* core/fonts/fonts.h: fonts ready to link; a program gets only those it names. ASCII, Latin-1,
 * arrows (U+2190 .. 2193), small triangles up, right, down, left (U+25B2, 25B6, 25BC, 25C0),
 * U+FFFD. They stand in core because they are constants like others, and in a folder of their own
 * because they are generated and have licences of their own: LICENCES.md.
 *
 *      name         bits   what
 *      fixed_WxH    1      misc-fixed in cells of W x H: fixed-width, for status lines and tables
 *      sans_N       4      DejaVu Sans, em of N pixels, with kerning; sans_16_2bit: in 2 bits
 *      digits_40    4      bold digits for instruments: digits and blank % + , - . / : degree minus
 */
#ifndef ETCH_FONTS_FONTS_H
#define ETCH_FONTS_FONTS_H

#include "../base/font.h"

extern const struct etch_font etch_font_fixed_5x8;
extern const struct etch_font etch_font_fixed_5x8_ascii; /* 95 glyphs, for the smallest programs */
extern const struct etch_font etch_font_fixed_6x13;
extern const struct etch_font etch_font_fixed_9x15;
extern const struct etch_font etch_font_fixed_10x20;
extern const struct etch_font etch_font_sans_12;
extern const struct etch_font etch_font_sans_16;
extern const struct etch_font etch_font_sans_16_2bit;
extern const struct etch_font etch_font_sans_24;
extern const struct etch_font etch_font_digits_40;

/* The kerning that both fonts of 16 pixels name: a program with both has it once. */
extern const struct etch_kern_pair etch_font_sans_16_pairs[];

#endif
