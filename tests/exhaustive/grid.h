/* tests/exhaustive/grid.h: every shape of a small grid, against its definition. `make exhaustive`
 * takes all of them, the unit suite `exhaustive` each of a fixed stride.
 *
 * Each function tries the shapes number first, first + step, .. and counts those with a wrong
 * pixel. Fast and small drawing functions are tried alike. */
#ifndef TESTS_EXHAUSTIVE_GRID_H
#define TESTS_EXHAUSTIVE_GRID_H

#include <stdint.h>

struct grid_count {
    int64_t tried, wrong;
};

/* Triangles with vertices on all 17 x 17 quarters of a 4 x 4 surface, borders included, in any
 * order of their vertices: coverage by 64-bit edge functions. 289^3 = 24,137,569 ordered triangles.
 */
struct grid_count grid_triangles(int64_t first, int64_t step);

/* The same triangles, each vertex moved by -32 .. 31 256ths of a pixel of its own: on
 * quarters no division has a rest worth losing, and on odd positions alone no difference is odd.
 * Every second one is clipped to 2 x 3 pixels. */
struct grid_count grid_triangles_moved(int64_t first, int64_t step);

/* Lines between all pixels of 12 x 12 under all 6,084 clip rectangles: the pixels of the
 * definition, masked. 2 * 126,157,824. */
struct grid_count grid_lines(int64_t first, int64_t step);

/* Circles and discs of radius -1 .. 7 round all pixels of 12 x 12 under all clip rectangles,
 * likewise. 3 * 7,884,864. */
struct grid_count grid_circles(int64_t first, int64_t step);

#endif
