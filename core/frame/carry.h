/* frame/carry.h: rows that a pass over neighbouring pixels keeps from strip to strip.
 *
 * A filter of radius 1 needs, for the rows of a strip, one row above and one below. What it reads
 * is drawn on a source surface that is ahead of the display's strips by that row; the rows that
 * the next strip will want again are kept. Nothing is drawn twice:
 *
 *      display strips    0 1 2 3 | 4 5 6 7 | 8 9
 *      source strips     0 1 2 3 4 | 5 6 7 8 | 9        radius 1
 *      kept                    3 4       7 8
 *
 *      etch_carry_init(&carry, kept, frame, 1, 1);
 *      for every strip:
 *          if (etch_carry_begin(&carry, strip, &source)) .. draw the scene on &source, in rgb565 ..
 *          etch_filter_draw(&carry, &source, strip, &etch_filter_weights_blur);
 *
 * Strips may come in any order and be areas of the frame: where one does not continue the last, the
 * rows (and columns) about it are drawn too. The pass writes the pixels inside strip->clip.
 *
 * Edge rule: beyond the frame stands its nearest pixel.
 *
 * Memory: `kept`, 2 * rows rows of the frame's width, and the source's pixels: as many rows as the
 * tallest strip and 2 * rows more, (only `rows` more if strips come in order, from the top).
 */
#ifndef ETCH_FRAME_CARRY_H
#define ETCH_FRAME_CARRY_H

#include "../base/surface.h"

struct etch_carry {
    uint16_t *kept; /* row y stands at (y mod 2 rows) * width of the frame */
    struct etch_rect frame;
    uint8_t rows, columns;   /* that the pass looks beyond a pixel, up or down and sideways */
    struct etch_rect source; /* what was drawn without a gap: rows y0 .. y1 - 1; the last
                                2 * rows of them are at hand */
};

/* Begins a frame. `kept` has 2 * rows * width elements and stays the caller's; rows and columns are
 * what the pass says. ETCH_EINVAL if kept is NULL, rows 0, or the frame is empty or not within
 * 0 .. 32767. Call it again for the next frame. */
enum etch_status etch_carry_init(struct etch_carry *c, uint16_t *kept, struct etch_rect frame,
                                 uint8_t rows, uint8_t columns);

/* Says what is to be drawn before the pass writes `strip`: sets the window, clip and stride of
 * `source`, whose planes the caller has set. False if all of it is at hand: draw nothing. */
bool etch_carry_begin(struct etch_carry *c, const struct etch_surface *strip,
                      struct etch_surface *source);

/* ---- for passes, yours too ---------------------------------------------------------------- */

/* Row y of the source, from column c->source.x0 on; rows beyond the frame are its nearest. */
const uint16_t *etch_carry_row(const struct etch_carry *c, const struct etch_surface *source,
                               int32_t y);

/* Ends a strip: keeps the source's last rows. Passes call it once, when they have read all. */
void etch_carry_end(struct etch_carry *c, const struct etch_surface *source);

#endif
