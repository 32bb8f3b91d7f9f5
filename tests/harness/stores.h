/* tests/harness/stores.h: core watched from inside: every store that it makes, every block that it
 * runs, every assertion that fails.
 *
 * `make stores` compiles core and hal with two instrumentations of the compiler, of which only the
 * calls are used: the thread sanitizer's, which calls __tsan_write2(address) and its like before
 * each store, and trace-pc, which calls __sanitizer_cov_trace_pc() in each basic block. It links
 * the functions of stores.c instead of the sanitizer's library: they look the address up on the
 * watched canvas, and count the blocks. ETCH_ASSERT is that of assert.h.
 * In all other builds nothing is counted and TEST_STORES is 0.
 */
#ifndef TESTS_HARNESS_STORES_H
#define TESTS_HARNESS_STORES_H

#ifndef TEST_STORES
#define TEST_STORES 0
#endif

#include <stdbool.h>
#include <stdint.h>

struct test_canvas;

/* Counts from now on, from zero, on this canvas and no other. */
void test_stores_watch(struct test_canvas *c);

/* Basic blocks that core ran since the last call: a measure of cost that no clock and no machine
 * disturbs, within a factor of a few for every compiler and option. */
uint32_t test_blocks(void);

/* Calls `call`. True if an ETCH_ASSERT of core failed in it; the call ends there. Where
 * TEST_STORES is 0 assertions are empty and it only calls. */
bool test_trips(void (*call)(void));

#endif
