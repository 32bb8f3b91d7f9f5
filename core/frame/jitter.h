/* frame/jitter.h: where within a pixel a frame that is drawn several times takes its samples.
 *
 * Of n offsets each lies in another column and in another row of an n x n division of the pixel, so
 * an edge that is nearly upright or nearly level meets them one after the other: n + 1 steps of
 * coverage where a square grid of as many has only sqrt(n) + 1. They sum to 0 in x and y.
 * Moving all vertices by (-x, -y) samples the picture at (x, y) beside the centres.
 *
 *      for (i = 0; i < 8; i++) {
 *          etch_jitter_sink_init(&jitter, &raster.sink, etch_jitter_8[i]);
 *          .. clear, draw with &jitter.sink, accumulate ..
 *      }
 *
 * Source: the columns of i and the rows of i k modulo n + 1, as in lattice rules (Korobov, 1959);
 * four of them are the rotated grid.
 */
#ifndef ETCH_FRAME_JITTER_H
#define ETCH_FRAME_JITTER_H

#include "../base/sink.h"

/* From the centre of a pixel, in 1/256 px. */
struct etch_offset_q8 {
    int16_t x, y;
};

extern const struct etch_offset_q8 etch_jitter_2[2];
extern const struct etch_offset_q8 etch_jitter_4[4];
extern const struct etch_offset_q8 etch_jitter_8[8];
extern const struct etch_offset_q8 etch_jitter_16[16];

/* The vertex as a sample at `offset` sees it: moved by its opposite. A position within 1 px of
 * +-2^23 leaves the range of base/sink.h; the painters draw it all the same. */
ETCH_INLINE struct etch_vertex etch_vertex_jitter(const struct etch_vertex *v,
                                                  struct etch_offset_q8 offset)
{
    struct etch_vertex moved = *v;

    moved.x_q8 -= offset.x;
    moved.y_q8 -= offset.y;
    return moved;
}

/* A sink before another one, which moves triangles, lines and points. It copies an etch_vertex:
 * what wider vertices have more of is not handed on. */
struct etch_jitter_sink {
    struct etch_sink sink; /* give &jitter.sink to the vertex stage */
    struct etch_sink *next;
    struct etch_offset_q8 offset;
};

void etch_jitter_sink_init(struct etch_jitter_sink *jitter, struct etch_sink *next,
                           struct etch_offset_q8 offset);

#endif
