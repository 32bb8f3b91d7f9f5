/* raster/edge.h: the edge walk; no part of the API.
 *
 * An edge from (xa, ya) down to (xb, yb) in 1/256 px crosses the row of centres y_c = 256 y + 128
 * at x_c = xa + (y_c - ya) dx / dy, and the first pixel whose centre is at or right of it is
 *
 *      x = ceil((x_c - 128) / 256) = ceil(M / dy)
 *      M = ceil(((xa - 128) dy + (y_c - ya) dx) / 256)
 *
 * A row further down M grows by exactly dx. So x and e = x dy - M, 0 <= e < dy, step by the
 * quotient and remainder of dx / dy: no rounding, no division, and two triangles that share an
 * edge share its x. The left edge's x is the first pixel inside, the right edge's the first
 * outside: the top-left rule without a case. dy and |dx| are at most 2^24, so all is 32-bit.
 */
#ifndef ETCH_RASTER_EDGE_H
#define ETCH_RASTER_EDGE_H

#include "triangle.h"

struct edge {
    int32_t x, e;                /* of the next row; 0 <= e < dy */
    int32_t dy;                  /* 1 .. 2^24 */
    int32_t quotient, remainder; /* of dx / dy, remainder 0 .. dy - 1 */
};

/* ceil((f dy + k rest) / 256) for tall edges, in halves so that nothing passes 2^26. */
ETCH_INLINE int32_t first_offset(int32_t f, int32_t k, int32_t dy, int32_t rest)
{
    return f * (dy >> 8) + k * (rest >> 8) + ((f * (dy & 255) + k * (rest & 255) + 255) >> 8);
}

/* n / d and the rest; the same in two forms. Cores without a divider go bit by bit, since
 * edges that flat have small quotients: 12 instructions and 10 a bit, where libgcc's division is 22
 * and 478 bytes. */
#if defined(__ARM_ARCH_6M__) || defined(__AVR__)
ETCH_INLINE uint32_t quotient_of(uint32_t n, uint32_t d, uint32_t *rest)
{
    uint32_t part = d, quotient = 0;

    while (part <= n >> 1)
        part <<= 1;
    for (; part >= d; part >>= 1) {
        quotient <<= 1;
        if (n >= part)
            n -= part, quotient++;
    }
    *rest = n;
    return quotient;
}
#else
/*@ requires d > 0 && \valid(rest);
    assigns *rest, \result \from n, d;
    ensures \result == n / d && *rest == n - \result * d && *rest < d; */
ETCH_INLINE uint32_t quotient_of(uint32_t n, uint32_t d, uint32_t *rest)
{
    const uint32_t quotient = n / d;

    *rest = n - quotient * d;
    return quotient;
}
#endif

/* Puts an edge from x = xa, dx across and dy down, on the row k below its end, k = 0 .. 255 and
 * below dy: with dx = q dy + r, M / dy = (xa - 128 + k q) / 256 + k r / (256 dy). The first term's
 * whole pixels are x; its fraction f leaves less than 2 dy, so ceil(M / dy) adds at most 2. `tall`:
 * dy may be 2^22 or more. Where dx < 0, q = ~(~dx / dy). */
ETCH_INLINE void edge_place(struct edge *g, int32_t xa, int32_t dx, int32_t dy, int32_t k,
                            bool tall)
{
    const int32_t sign = dx >> 31;
    uint32_t rest = (uint32_t)(dx ^ sign);
    int32_t quotient = sign;

    if (rest >= (uint32_t)dy) /* flatter than 45 degrees */
        quotient ^= (int32_t)quotient_of(rest, (uint32_t)dy, &rest);

    const int32_t remainder = ((int32_t)rest ^ sign) + (sign & dy);
    const int32_t start = xa - 128 + k * quotient, f = start & 255;
    int32_t x = start >> 8;
    int32_t e = !tall || dy < INT32_C(1) << 22 ? -((f * dy + k * remainder + 255) >> 8)
                                               : -first_offset(f, k, dy, remainder);

    if (e < 0)
        e += dy, x++;
    if (e < 0)
        e += dy, x++;
    g->x = x;
    g->e = e;
    g->dy = dy;
    g->quotient = quotient;
    g->remainder = remainder;
}

/* Puts the edge a, b, which crosses a row, on its first row. */
ETCH_INLINE void edge_start(struct edge *g, struct etch_point_q8 a, struct etch_point_q8 b,
                            bool tall)
{
    const int32_t dy = b.y - a.y, dx = b.x - a.x;

    edge_place(g, a.x, dx, dy, (128 - a.y) & 255, tall);
}

/* x first: gcc would put its sum between the subtraction of e and the branch on it, and compare
 * once more. No instruction. */
#if defined(__GNUC__)
#define STEP_FIRST(x, e) __asm__("" : "+r"(x), "+r"(e))
#else
#define STEP_FIRST(x, e) ((void)0)
#endif

/* Writes x to *out and goes a row down: M grows by dx = quotient dy + remainder. */
/*@ requires \valid(g) && \valid(out) && \separated(g, out);
    requires 0 <= g->remainder < g->dy <= 0x1000000 && 0 <= g->e < g->dy;
    requires -0x8000 <= g->x <= 0x7FFF && -0x1000000 <= g->quotient <= 0x1000000;
    assigns *out, g->x, g->e;
    ensures *out == \old(g->x) && 0 <= g->e < g->dy;
    ensures (g->x - \old(g->x) - g->quotient) * g->dy == g->e - \old(g->e) + g->remainder; */
ETCH_INLINE void edge_step(struct edge *g, int16_t *out)
{
    *out = (int16_t)g->x;
    g->x += g->quotient;
    STEP_FIRST(g->x, g->e);
    g->e -= g->remainder;
    if (g->e < 0)
        g->e += g->dy, g->x++;
}

/* Writes the edge's x of the next n >= 1 rows to out[0], out[2], ..; returns the next. */
ETCH_INLINE int16_t *edge_walk(struct edge *edge, int16_t *out, int32_t n)
{
    int16_t *const end = out + 2 * n;
    struct edge g = *edge;

    if ((n & 1) != 0) {
        edge_step(&g, out);
        out += 2;
    }
    for (; out != end; out += 4) {
        edge_step(&g, &out[0]);
        edge_step(&g, &out[2]);
    }
    edge->x = g.x;
    edge->e = g.e;
    return out;
}

/* The edge from a down to b on its first n >= 1 rows, as edge_walk writes them; dy < 2^22. Returns
 * the next row's. Some 60 instructions and 6.5 a row on ARMv6-M, in assembly (leaf/) 45 and 5.7. */
int16_t *etch_edge_run(struct etch_point_q8 a, struct etch_point_q8 b, int16_t *out, int32_t n);

#endif
