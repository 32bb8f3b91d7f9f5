/* tests/oracle/wide.h: unsigned 128-bit integers of two words, for exact rationals. No compiler
 * extension, so that the oracle also runs on targets that have no wide type. */
#ifndef TESTS_ORACLE_WIDE_H
#define TESTS_ORACLE_WIDE_H

#include <stdbool.h>
#include <stdint.h>

struct wide {
    uint64_t hi, lo;
};

struct wide wide_product(uint64_t a, uint64_t b);
struct wide wide_sum(struct wide a, struct wide b);      /* below 2^128 */
struct wide wide_distance(struct wide a, struct wide b); /* |a - b| */
struct wide wide_scale(struct wide a, uint32_t k);       /* a * k below 2^128 */
bool wide_at_most(struct wide a, struct wide b);         /* a <= b */

#endif
