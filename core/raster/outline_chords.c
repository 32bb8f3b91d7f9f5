/* raster/outline_chords.c: how fine arcs are. Called by the outlines. See outline.h.
 *
 * A chord of 1 / n of a turn is r (1 - cos(pi / n)) <= r pi^2 / (2 n^2) from its arc, so n^2 >= 316
 * r, r in px, keeps that within 1/64. */
#include "outline.h"

uint16_t etch_outline_chords(int32_t radius_q8)
{
    uint32_t n = 8;

    while (n < 1024 &&
           (uint64_t)n * n * 256 < (uint64_t)316 * (uint32_t)(radius_q8 < 0 ? 0 : radius_q8))
        n *= 2;
    return (uint16_t)n;
}
