/* wp: edge_step,quotient_of,step
 * spec: quotient_of
 * proved: an edge is placed on its first row (raster/edge.h) without overflow, for every
 *          edge that crosses a row; a step down adds dx to x dy - e, exactly, and keeps 0 <=
 *          e < dy
 * assumed: an edge that is placed crosses a row; a step begins at an x that 16 bits hold */
#include "prove.h"
#include "core/raster/edge.h"

/* Every edge whose height has its highest bit at n, falling to the left or not. */
static void place(int n)
{
    const int64_t low = 1LL << n, high = (2LL << n) - 1 < 1 << 24 ? (2LL << n) - 1 : 1 << 24;
    const int32_t xa = (int32_t)any(-8388608, 8388608);
    const int32_t k = (int32_t)any(0, high - 1 < 255 ? high - 1 : 255);
    struct edge g;

    edge_place(&g, xa, (int32_t)any(0, 1 << 24), (int32_t)any(low, high), k, true);
    edge_place(&g, xa, (int32_t)any(-(1 << 24), -1), (int32_t)any(low, high), k, true);
    if (n < 22) {
        edge_place(&g, xa, (int32_t)any(0, 1 << 24), (int32_t)any(low, high), k, false);
        edge_place(&g, xa, (int32_t)any(-(1 << 24), -1), (int32_t)any(low, high), k, false);
    }
}

static void step(void)
{
    struct edge g;
    int16_t out;

    g.dy = (int32_t)any(1, 1 << 24);
    g.e = (int32_t)any(0, (1 << 24) - 1);
    g.remainder = (int32_t)any(0, (1 << 24) - 1);
    g.quotient = (int32_t)any(-(1 << 24), 1 << 24);
    g.x = (int32_t)any(INT16_MIN, INT16_MAX);
    if (g.e < g.dy && g.remainder < g.dy)
        edge_step(&g, &out);
}

void prove(void)
{
    uint32_t rest;

    (void)quotient_of(ANY_U32, (uint32_t)any(1, UINT32_MAX), &rest);
    for (int n = 0; n <= 24; n++)
        place(n);
    step();
}
