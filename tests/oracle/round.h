/* tests/oracle/round.h: ellipses, rounded rectangles, rings and arcs by definition, pixel by pixel.
 */
#ifndef TESTS_ORACLE_ROUND_H
#define TESTS_ORACLE_ROUND_H

#include <stdbool.h>
#include <stdint.h>

/* (dx, dy) from the centre: half a pixel nearer to it, across or down, is in the closed ellipse. */
bool oracle_ellipse_covers(int32_t rx, int32_t ry, int32_t dx, int32_t dy);

/* The rectangle without what lies off the discs of its corners. */
bool oracle_round_rect_covers(int32_t w, int32_t h, int32_t r, int32_t dx, int32_t dy);

/* The direction is at or clockwise after `from` and before `from` + `sweep`; the centre is
 * direction 0. */
bool oracle_sector_covers(uint16_t from, uint32_t sweep, int32_t dx, int32_t dy);

/* A disc less a disc, of the sector. */
bool oracle_arc_covers(int32_t outer, int32_t inner, uint16_t from, uint32_t sweep, int32_t dx,
                       int32_t dy);

#endif
