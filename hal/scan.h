/* hal/scan.h: when to begin a frame so that it does not tear.
 *
 * A panel reads its memory line by line and rests between two passes; its tearing-effect line
 * (TE; command 35 00 of most controllers) rises when it begins to rest. A frame tears if one
 * pass shows lines of both the old and the new one: if the write pointer crosses the scan line.
 *
 *      line                              from the pulse on, with t = period / (lines + blank):
 *      0 |      \        \               line y is read from (blank + y) t on, for t
 *        | .     \   .    \
 *        |   .    \     .  \    \ scan   it is written from
 *        |     .   \       .\   . write     delay + y F / lines on, for F / lines
 *   last |       .  \        \.
 *         pulse ^ blank  ^ pulse
 *
 * Either the frame stays ahead of the scan (begun at the pulse, F less than about a period), or
 * behind it, and ahead of the next pass (begun after the first line was read, F less than about
 * two periods). The plan is the earliest of the two that is safe. */
#ifndef ETCH_HAL_SCAN_H
#define ETCH_HAL_SCAN_H

#include "../core/base/fixed.h"

struct etch_scan {
    uint32_t period_us; /* from pulse to pulse, 1 .. 1000000; 16667 at 60 Hz */
    uint16_t lines;     /* of the glass, 1 .. 32767 */
    uint16_t blank;     /* lines of rest, 0 .. 32767 */
    bool along;         /* the frame's rows are sent in the order in which they are read: turn 0,
                           or turn 2 with ETCH_LCD_FOLLOW_SCAN, on panels whose memory row 0 is
                           on top (not ETCH_LCD_FLIP_ROWS). Else only the rest is safe */
};

/* How long after the pulse to begin a frame that is sent evenly within write_us from its first
 * flush, any line at most jitter_us later than that: 0 .. 2 period_us. Times are in microseconds
 * and each at most 1000000. ETCH_ERANGE: there is no such time: the bus (or drawing) is too slow
 * for this panel and direction, and the frame will tear; a slower refresh rate, fewer lines, or a
 * faster bus would help. Exact: it says no only where every start tears. */
int32_t etch_scan_plan(const struct etch_scan *scan, uint32_t write_us, uint32_t jitter_us);

#endif
