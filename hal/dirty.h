/* hal/dirty.h: what changed since the last frame, as few rectangles.
 *
 *      etch_dirty_add(&dirty, where_the_hand_was);
 *      etch_dirty_add(&dirty, where_it_is_now);
 *      for (s = etch_frame_begin_areas(&frame, dirty.area, dirty.count); ..)
 *      if (etch_frame_end(&frame) == 0)
 *          dirty.count = 0;              (after an error they are drawn again)
 *
 * The areas never overlap, so no pixel is drawn or sent twice, and together hold at least all
 * that was added. Two become one where that sends few pixels more: a transaction costs about as
 * much as `slack` pixels. When there is no more place, the two whose union wastes least are
 * joined. A new frame loop begins with everything: add the whole frame.
 *
 * Displays whose areas must be aligned (align_x, align_y) grow them afterwards: then neighbours
 * may overlap by the growth, which costs but does no harm. */
#ifndef ETCH_HAL_DIRTY_H
#define ETCH_HAL_DIRTY_H

#include "../core/base/rect.h"

#define ETCH_DIRTY_MOST 8

/* Zero it before use, or set slack. */
struct etch_dirty {
    struct etch_rect area[ETCH_DIRTY_MOST];
    uint8_t count;
    uint16_t slack; /* pixels; 0 stands for 32 */
};

/* Adds a rectangle; an empty one is nothing. About 100 instructions for each area there is, and
 * once more for each that is joined. */
void etch_dirty_add(struct etch_dirty *dirty, struct etch_rect area);

#endif
