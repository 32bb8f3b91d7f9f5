/* leaf/vector128/vector.h: vectors of 128 bits, by the extension that gcc and clang share; no part
 * of the API.
 *
 * The leaves of this folder stand in for the portable loops on 64-bit little-endian machines (SSE2,
 * NEON). Lane i of a vector is pixel i. All of it is integers, and the pixels are the portable ones
 * bit for bit: `make bench-leaves`.
 */
#ifndef ETCH_LEAF_VECTOR_H
#define ETCH_LEAF_VECTOR_H

#include "../../base/fixed.h"

_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__,
               "the portable files serve every other machine");

typedef uint32_t vector_u32 __attribute__((vector_size(16)));
typedef int32_t vector_s32 __attribute__((vector_size(16)));
typedef uint16_t vector_u16 __attribute__((vector_size(16)));
typedef int16_t vector_s16 __attribute__((vector_size(16)));
typedef uint64_t vector_u64 __attribute__((vector_size(16)));

/* The same in memory, where elements stand at any even address. */
typedef vector_u16 __attribute__((aligned(2), may_alias)) vector_pixels;
typedef uint64_t __attribute__((aligned(2), may_alias)) four_pixels;
typedef uint32_t __attribute__((aligned(2), may_alias)) two_pixels;

ETCH_INLINE vector_u16 vector_load(const uint16_t *p)
{
    return *(const vector_pixels *)p;
}

ETCH_INLINE void vector_store(uint16_t *p, vector_u16 v)
{
    *(vector_pixels *)p = v;
}

/* v in every lane. */
ETCH_INLINE vector_u32 vector_all(uint32_t v)
{
    return (vector_u32){v, v, v, v};
}

/* v, v + d, v + 2 d, v + 3 d modulo 2^32. */
ETCH_INLINE vector_u32 vector_ramp(uint32_t v, uint32_t d)
{
    return vector_all(v) + vector_all(d) * (vector_u32){0, 1, 2, 3};
}

/* The upper halves of a's lanes, then of b's. Two forms: of the second gcc 12 makes seven
 * instructions on SSE2, of the first three. */
#if defined(__SSE2__)
ETCH_INLINE vector_u16 vector_upper(vector_u32 a, vector_u32 b)
{
    return (vector_u16)__builtin_ia32_packssdw128((vector_s32)a >> 16, (vector_s32)b >> 16);
}
#else
ETCH_INLINE vector_u16 vector_upper(vector_u32 a, vector_u32 b)
{
    return __builtin_shufflevector((vector_u16)a, (vector_u16)b, 1, 3, 5, 7, 9, 11, 13, 15);
}
#endif

/* Of a mask's lanes, all ones or all zeros, bits 2 i and 2 i + 1 are lane i. Two forms again. */
#if defined(__SSE2__)
typedef char vector_bytes __attribute__((vector_size(16)));

ETCH_INLINE uint32_t vector_bits(vector_s16 mask)
{
    return (uint32_t)__builtin_ia32_pmovmskb128((vector_bytes)mask);
}
#else
ETCH_INLINE uint32_t vector_bits(vector_s16 mask)
{
    const vector_u16 own = {3, 12, 48, 192, 768, 3072, 12288, 49152};
    const vector_u64 both = (vector_u64)((vector_u16)mask & own);
    const uint64_t four = both[0] | both[1];
    const uint32_t two = (uint32_t)(four >> 32 | (four & UINT32_MAX));

    return (two >> 16 | two) & 0xFFFF;
}
#endif

/* The first n = 1 .. 4 lanes to p. */
ETCH_INLINE void vector_store_few(uint16_t *p, vector_u16 v, uint32_t n)
{
    uint64_t low = ((vector_u64)v)[0];

    if (n == 4) {
        *(four_pixels *)p = low;
        return;
    }
    if ((n & 2) != 0) {
        *(two_pixels *)p = (uint32_t)(low & UINT32_MAX);
        low >>= 32;
        p += 2;
    }
    if ((n & 1) != 0)
        *p = (uint16_t)(low & 0xFFFF);
}

#endif
