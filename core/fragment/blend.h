/* fragment/blend.h: stages that join a fragment's colour with what the pixel has (stage.h).
 *
 *      {etch_stage_read, NULL}, {etch_stage_blend_alpha, NULL}, {etch_stage_write, NULL}
 *
 * S is the chunk's colour, with all of its fraction bits, D the pixel's step of RGB565; the result
 * is rounded to a step once, to nearest, ties upwards, and is the exact rounding of S and D. No
 * channel leaves its range. Byte orders are the concern of read and write (write.h) alone.
 */
#ifndef ETCH_FRAGMENT_BLEND_H
#define ETCH_FRAGMENT_BLEND_H

#include "stage.h"

/* S a + D (1 - a), a the chunk's alpha / 255 with its fraction bits. Alpha 0 leaves the pixel bit
 * for bit, 255 makes it S. */
etch_stage_function etch_stage_blend_alpha;

/* The same with one alpha for all; data: const struct etch_blend_constant. */
struct etch_blend_constant {
    uint8_t alpha;
};
etch_stage_function etch_stage_blend_constant;

/* S + D, at most full. */
etch_stage_function etch_stage_blend_add;

/* S a + D, at most full: light that fades with alpha. */
etch_stage_function etch_stage_blend_add_alpha;

/* S D, 1 the full channel: black stays black, under white D stays D. */
etch_stage_function etch_stage_blend_multiply;

#endif
