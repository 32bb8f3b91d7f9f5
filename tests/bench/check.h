/* bench/check.h: what a workload's picture has to be, pixel by pixel.
 *
 * Slow and obvious: shapes by their definitions over every pixel of their box, triangles by
 * edge functions, values by exact rationals. Host only; knows nothing of etch but its contract.
 */
#ifndef BENCH_CHECK_H
#define BENCH_CHECK_H

#include <stdbool.h>
#include <stdint.h>

#include "workloads.h"

/* What the last primitive that covers a pixel gives it, in 1/65536 of an RGB565 step. */
struct expected {
    bool drawn;
    int32_t channel[3];
};

/* One picture: what was drawn, and what should have been. */
struct check {
    const uint16_t *color, *depth;        /* as etch drew it */
    struct expected expected[WL_H][WL_W]; /* workloads without depth: the last one wins */
    int64_t least[WL_H][WL_W];            /* with depth: least exact depth, 1/65536 unit */
    bool matched[WL_H][WL_W];             /* a triangle of that depth has the colour drawn */
    uint32_t primitives, pixels;          /* found on the way, of all frames */
};

#define CHECK_FAR INT64_MAX

/* A vertex in 1/256 px, pixel centres at + 128; depth in 1/65536 units; 8-bit channels. */
struct check_vertex {
    int32_t x_q8, y_q8;
    uint32_t z_q16;
    uint8_t channel[3];
};

/* Largest distance from the exact value: 1/2 + 1/64, and 1 for what division drops. */
#define CHECK_TOLERANCE (32768 + 1024 + 1)

/* 2D: W1..W5. */
void check_2d(struct check *c, int workload);

/* Triangles: W6..W11. Without depth fills in `expected`, with depth `least` and `matched`. */
void check_triangles(struct check *c, int workload);

/* Texture: W12 and W13. Without depth fills in `expected` and `matched`. */
void check_textures(struct check *c);

/* W14: text. */
void check_text(struct check *c);

/* W15: false, and says why, if the vertex stage puts a triangle elsewhere; as above otherwise. */
bool check_torus(struct check *c, uint8_t frame);

/* The triangle over the pixels it covers, in the flat channels (1/65536 step) if not NULL;
 * `pass` 0: expected; 1: least; 2: matched. */
void check_triangle(struct check *c, const struct check_vertex v[3], const int32_t *flat, int pass);

/* True if an RGB565 colour lies within the tolerance of the exact channels. */
bool check_color(uint16_t color, const int32_t exact[3]);

#endif
