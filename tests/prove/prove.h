/* prove/prove.h: what the proofs share. Each tests/prove/NAME.c includes a file of core and calls
 * its functions with every value of the stated ranges; Frama-C's EVA then shows that no signed or
 * unsigned sum, product, shift or conversion leaves its type, no division is by zero, and every
 * CHECK holds.
 *
 * Unsigned arithmetic that is meant to wrap stands in helpers called wrap: their contracts below
 * stand for them, and are all that is assumed. */
#ifndef PROVE_H
#define PROVE_H

#include <stdint.h>

extern volatile int any_input;

/*@ assigns \result \from lo, hi, any_input; ensures lo <= \result <= hi; */
int64_t any(int64_t lo, int64_t hi);
/*@ assigns \result \from lo, hi, any_input; ensures lo <= \result <= hi; */
uint64_t any_unsigned(uint64_t lo, uint64_t hi);

#define ANY_S32 (int32_t) any(INT32_MIN, INT32_MAX)
#define ANY_U32 (uint32_t) any(0, UINT32_MAX)
#define ANY_S16 (int16_t) any(INT16_MIN, INT16_MAX)

/*@ assigns \result \from a, b; ensures \result == (uint32_t)(a + b); */
static inline uint32_t etch_wrap_add(uint32_t a, uint32_t b);
/*@ assigns \result \from a, b; ensures \result == (uint32_t)(a - b); */
static inline uint32_t etch_wrap_sub(uint32_t a, uint32_t b);
/*@ assigns \result \from a, b; ensures \result == (uint32_t)(a * b); */
static inline uint32_t etch_wrap_mul(uint32_t a, uint32_t b);
/*@ requires -31 <= s <= 31; assigns \result \from v, s; */
static inline uint32_t etch_wrap_scale(int32_t v, int8_t s);

#endif
