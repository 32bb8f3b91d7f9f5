/* tests/oracle/texture.h: exact texture coordinates, by their definition. Slow and plain; nothing
 * here is shared with core. */
#ifndef TESTS_ORACLE_TEXTURE_H
#define TESTS_ORACLE_TEXTURE_H

#include "triangle.h"

/* floor(n / d) for n / d < 2^63, 0 < d < 2^126. */
uint64_t oracle_quotient(struct wide n, struct wide d);

/* The coordinate at the centre of pixel (x, y), covered or not, of one that is c[i] (16.16) at the
 * caller's vertex i, biased by 2^31, times 2^bits, rounded down. w NULL: linear on the screen. Else
 * in perspective, w = 1 .. 65535. The true biased value, and the sum of the weights, must be
 * positive; bits <= 12. */
uint64_t oracle_texture(const struct oracle_triangle *t, int32_t x, int32_t y, const int32_t c[3],
                        const uint32_t w[3], uint8_t bits);

#endif
