/* fragment/logic.h: the sixteen raster operations as stages (stage.h), in place of blending.
 *
 *      {etch_stage_read, NULL}, {etch_stage_logic_xor, NULL}, {etch_stage_write, NULL}
 *
 * S is the fragment's colour rounded to RGB565, D the pixel; the operation is on their 16 bits, and
 * the bits are those of etch_rgb565 in both byte orders. No data. Drawing with xor twice restores
 * what was there.
 */
#ifndef ETCH_FRAGMENT_LOGIC_H
#define ETCH_FRAGMENT_LOGIC_H

#include "stage.h"

etch_stage_function etch_stage_logic_clear;         /* 0 */
etch_stage_function etch_stage_logic_and;           /* S & D */
etch_stage_function etch_stage_logic_and_reverse;   /* S & ~D */
etch_stage_function etch_stage_logic_copy;          /* S */
etch_stage_function etch_stage_logic_and_inverted;  /* ~S & D */
etch_stage_function etch_stage_logic_noop;          /* D */
etch_stage_function etch_stage_logic_xor;           /* S ^ D */
etch_stage_function etch_stage_logic_or;            /* S | D */
etch_stage_function etch_stage_logic_nor;           /* ~(S | D) */
etch_stage_function etch_stage_logic_equiv;         /* ~(S ^ D) */
etch_stage_function etch_stage_logic_invert;        /* ~D */
etch_stage_function etch_stage_logic_or_reverse;    /* S | ~D */
etch_stage_function etch_stage_logic_copy_inverted; /* ~S */
etch_stage_function etch_stage_logic_or_inverted;   /* ~S | D */
etch_stage_function etch_stage_logic_nand;          /* ~(S & D) */
etch_stage_function etch_stage_logic_set;           /* all ones */

#endif
