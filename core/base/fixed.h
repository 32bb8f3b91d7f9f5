/* base/fixed.h: integer arithmetic that every stage shares.
 *
 * Fixed-point formats stand in names: `x_q8` counts 1/256, `scale_q16` counts 1/65536.
 * `int` may have 16 bits: a product of two int16_t or uint16_t overflows it on one core or
 * the other, so products go through the helpers below. Helpers called `wrap` are the only
 * places where unsigned arithmetic is meant to wrap round; everywhere else it does not.
 */
#ifndef ETCH_BASE_FIXED_H
#define ETCH_BASE_FIXED_H

#include <limits.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A caller's bug (NULL surface, misaligned buffer) trips ETCH_ASSERT. It is empty unless
 * the build defines it, e.g. -D'ETCH_ASSERT(x)=((x)?(void)0:abort())'. */
#ifndef ETCH_ASSERT
#define ETCH_ASSERT(condition) ((void)0)
#endif

#if defined(__GNUC__)
#define ETCH_INLINE static inline __attribute__((always_inline, unused))
#define ETCH_COLD __attribute__((noinline, cold))
/* Never inlined, so that its locals do not stand on the stack under all else that its caller calls.
 */
#define ETCH_APART __attribute__((noinline))
/* Makes the compiler take the value of a local as it stands, so that in a hot loop it neither
 * rearranges sums nor computes them a second time. No instruction. */
#define ETCH_KEEP(local) __asm__("" : "+r"(local))
#else
#define ETCH_INLINE static inline
#define ETCH_COLD
#define ETCH_APART
#define ETCH_KEEP(local) ((void)0)
#endif

/* Unrolls the loop that follows n times, where the compiler knows how. */
#if defined(__clang__) || (defined(__GNUC__) && __GNUC__ >= 8)
#define ETCH_PRAGMA(text) _Pragma(#text)
#define ETCH_UNROLL(n) ETCH_PRAGMA(GCC unroll n)
#else
#define ETCH_UNROLL(n)
#endif

_Static_assert(CHAR_BIT == 8, "etch needs 8-bit bytes");
_Static_assert((INT32_C(-3) >> 1) == INT32_C(-2), "etch needs an arithmetic right shift");

/* What set-up functions return: 0 or a negative reason. Drawing functions return void. */
enum etch_status {
    ETCH_OK = 0,
    ETCH_EINVAL = -1, /* an argument outside its documented range */
    ETCH_ERANGE = -2, /* a result that its number format cannot hold */
    ETCH_ENOMEM = -3, /* the caller's buffer is too small */
    ETCH_EIO = -4     /* a display or bus failed */
};

/* 16.16 signed: -32768 .. 32767 + 65535/65536. */
typedef int32_t etch_q16;

#define ETCH_Q16_ONE INT32_C(65536)

/* A 16.16 constant from a fraction of integer constants, truncated; |n| <= 32767. */
#define ETCH_Q16(n, d) ((etch_q16)(INT64_C(65536) * (n) / (d)))

/* ---- products, exact ----------------------------------------------------------------- */

ETCH_INLINE int32_t etch_mul_s16(int16_t a, int16_t b)
{
    return (int32_t)a * b;
}

ETCH_INLINE uint32_t etch_mul_u16(uint16_t a, uint16_t b)
{
    return (uint32_t)a * b;
}

ETCH_INLINE int64_t etch_mul_s32(int32_t a, int32_t b)
{
    return (int64_t)a * b;
}

/* The upper half of the product, rounded down; b >= 0. The same on every core, in two forms. This
 * one multiplies 32 x 32 -> 64. */
ETCH_INLINE int32_t etch_mul_high_wide(int32_t a, int32_t b)
{
    return (int32_t)(etch_mul_s32(a, b) >> 32);
}

/* This one makes four products of halves, and loses no carry. a = ah 2^16 + al,
 * b = bh 2^16 + bl, 0 <= bh < 2^15: |ah bl| + (al bl >> 16) < 2^31 and al bh + 2^16 < 2^31. */
ETCH_INLINE int32_t etch_mul_high_split(int32_t a, int32_t b)
{
    const int32_t ah = a >> 16, al = a & 0xFFFF, bh = b >> 16, bl = b & 0xFFFF;
    const int32_t middle = ah * bl + (int32_t)((uint32_t)al * (uint32_t)bl >> 16);

    return ah * bh + (middle >> 16) + ((al * bh + (middle & 0xFFFF)) >> 16);
}

#if defined(__ARM_ARCH_6M__) || defined(__AVR__) /* no 32 x 32 -> 64 multiply */
ETCH_INLINE int32_t etch_mul_high(int32_t a, int32_t b)
{
    return etch_mul_high_split(a, b);
}
#else
ETCH_INLINE int32_t etch_mul_high(int32_t a, int32_t b)
{
    return etch_mul_high_wide(a, b);
}
#endif

/* Leading zero bits of v; 32 for 0. The same in two forms: by an instruction where the core has
 * one, else some 20 instructions on ARMv6-M. */
#if defined(__GNUC__) && (defined(__x86_64__) || defined(__aarch64__) || defined(__ARM_FEATURE_CLZ))
ETCH_INLINE uint8_t etch_leading_zeros(uint32_t v)
{
    return v == 0 ? 32 : (uint8_t)__builtin_clz(v);
}
#else
ETCH_INLINE uint8_t etch_leading_zeros(uint32_t v)
{
    uint8_t n = 0;

    if (v >> 16 == 0)
        v <<= 16, n = 16;
    if (v >> 24 == 0)
        v <<= 8, n = (uint8_t)(n + 8);
    if (v >> 28 == 0)
        v <<= 4, n = (uint8_t)(n + 4);
    if (v >> 30 == 0)
        v <<= 2, n = (uint8_t)(n + 2);
    if (v >> 31 == 0)
        n = (uint8_t)(n + (v == 0 ? 2 : 1));
    return n;
}
#endif

/* ---- arithmetic modulo 2^32, by intent ------------------------------------------------ */

ETCH_INLINE uint32_t etch_wrap_add(uint32_t a, uint32_t b)
{
    return a + b;
}

ETCH_INLINE uint32_t etch_wrap_sub(uint32_t a, uint32_t b)
{
    return a - b;
}

ETCH_INLINE uint32_t etch_wrap_mul(uint32_t a, uint32_t b)
{
    return a * b;
}

/* v 2^s, modulo 2^32 to the left and rounded to nearest to the right; s = -31 .. 31. */
ETCH_INLINE uint32_t etch_wrap_scale(int32_t v, int8_t s)
{
    return s >= 0 ? (uint32_t)v << s : (uint32_t)(v >> -s) + (uint32_t)(v >> (-s - 1) & 1);
}

/* ---- 16.16 ---------------------------------------------------------------------------- */

/* The nearest int32_t to a 64-bit value. */
ETCH_INLINE int32_t etch_saturate_s32(int64_t v)
{
    return v > INT32_MAX ? INT32_MAX : v < INT32_MIN ? INT32_MIN : (int32_t)v;
}

/* a * b, rounded half up, saturated to the 16.16 range. */
ETCH_INLINE etch_q16 etch_q16_mul(etch_q16 a, etch_q16 b)
{
    return etch_saturate_s32((etch_mul_s32(a, b) + 32768) >> 16);
}

/* 16.16 to 1/256, rounded half up. Every input; result -2^23 .. 2^23 inclusive. */
ETCH_INLINE int32_t etch_snap_q8(etch_q16 v)
{
    return (v >> 8) + ((v >> 7) & 1);
}

/* ---- division: core's own, so that nothing pulls in libgcc's 64-bit one ---------------- */

struct etch_quotient {
    uint64_t quotient, remainder;
};

/* n / d for d in 1 .. 2^63. Shift and subtract, about 8 instructions a quotient bit on
 * ARMv6-M; a quotient of few bits costs little. */
/*@ requires 1 <= d <= 0x8000000000000000;
    assigns \result \from n, d;
    ensures n == \result.quotient * d + \result.remainder && \result.remainder < d; */
struct etch_quotient etch_divide_u64(uint64_t n, uint64_t d);

/* n / d rounded half up (towards +infinity on a tie) and saturated to int32_t, for every n
 * above INT64_MIN and every d but 0 and INT64_MIN. */
/*@ requires -0x7FFFFFFFFFFFFFFF <= n && -0x7FFFFFFFFFFFFFFF <= d && d != 0;
    assigns \result \from n, d; */
int32_t etch_divide_round_s64(int64_t n, int64_t d);

/* a / b in 16.16, rounded half up, saturated. b = 0 gives the saturated value of a's sign,
 * 0 for 0 / 0. */
etch_q16 etch_q16_div(etch_q16 a, etch_q16 b);

/* floor(sqrt(v)). Source: C. Woo's abacus method, one bit a step, 16 steps. */
uint16_t etch_sqrt_u32(uint32_t v);

#endif
