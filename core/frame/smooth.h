/* frame/smooth.h: anti-aliasing of a finished picture (morphological, of the FXAA kind).
 *
 * Looks at pixels alone, so it smooths whatever drew them, lines and circles too, and costs no
 * samples; it cannot know what lay between pixels, and text gets softer corners. Where a stair of
 * two colours is found its steps are blended as an edge from the middle of one step to the middle
 * of the next would cover them:
 *
 *      ##########..........              ########++--........
 *      ..........##########      ->      ........--++########      (+ and -: mixed)
 *
 *  1   luma = 5 (red + green) + 2 blue in output steps, 0 .. 532. A pixel whose contrast, the
 *      range of luma over it and its four neighbours, is below max(24, greatest / 8) stays.
 *  2   Second differences of luma over 3 x 3 say whether the edge runs along the row (also on a
 *      tie) or the column, and the greater first difference on which side of the pixel it lies (up
 *      or left on a tie): the side neighbour.
 *  3   Both rows of the edge, the pixel's and its side's, are followed in both directions until
 *      their summed luma changes by half of the first difference or more: after n >= 1 and p >= 1
 *      pixels, up to ETCH_SMOOTH_COLUMNS sideways and carry->rows up and down; beyond, one more
 *      counts.
 *  4   The step is L = n + p - 1 pixels long and m = min(n, p) is the way to its near end. If there
 *      the luma turns towards the side's, the pixel becomes
 *          pixel + (side - pixel) (L - 2 m + 1) / (2 L),    each channel rounded once, half up.
 *
 * Straight edges along rows and columns, areas of one colour and single pixels stay as they are.
 * Everything is integer, and depends on the picture alone, so strips give what the whole frame
 * gives.
 *
 * Use: see carry.h, with rows = 2 and columns = ETCH_SMOOTH_COLUMNS: five rows are at hand, four of
 * them kept. More rows follow steeper edges farther. 100 instructions for a pixel without
 * contrast, some 1300 where edges are.
 *
 * Source: the idea of T. Lottes, FXAA (NVIDIA, 2009), and A. Reshetov, Morphological Antialiasing
 * (2009).
 */
#ifndef ETCH_FRAME_SMOOTH_H
#define ETCH_FRAME_SMOOTH_H

#include "carry.h"

#define ETCH_SMOOTH_COLUMNS 8

void etch_smooth_draw(struct etch_carry *c, const struct etch_surface *source,
                      const struct etch_surface *strip);

/* The same to a strip in rgb565_swapped. */
void etch_smooth_draw_swapped(struct etch_carry *c, const struct etch_surface *source,
                              const struct etch_surface *strip);

#endif
