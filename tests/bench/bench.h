/* bench/bench.h: what a workload, the program that runs it and the machine it runs on share.
 *
 * main.c is linked with one workload (chosen by -DWORKLOAD=n) and with start.c (Cortex-M) or
 * host.c. It prepares the lists, clears the planes, and calls the workload between two markers;
 * only what lies between them is counted. Then it writes out the planes, which must be right
 * for the count to be believed.
 */
#ifndef BENCH_BENCH_H
#define BENCH_BENCH_H

#include "../../core/base/surface.h"
#include "workloads.h"

struct bench_workload {
    uint8_t frames;        /* pictures drawn, each counted */
    bool depth;            /* has a depth plane, cleared to 65535 beforehand */
    void (*prepare)(void); /* makes the lists, once; not counted */
    void (*draw)(const struct etch_surface *s, uint8_t frame);
};

extern const struct bench_workload bench_w1, bench_w2, bench_w3, bench_w4, bench_w5, bench_w6,
    bench_w7, bench_w8, bench_w9, bench_w10, bench_w11, bench_w12, bench_w13, bench_w14, bench_w15;

/* W15 without its rasteriser: hands the triangles of a frame to `sink`. After prepare. */
struct etch_sink;
void bench_torus_draw(uint8_t frame, struct etch_sink *sink);

#define BENCH_CLEAR_COLOR 0x8410 /* what W1 draws; all others draw on 0 */

/* Given by start.c or host.c: a new file. */
void bench_write(const char *name, const void *data, uint32_t bytes);

#endif
