/* tests/harness/stores.h: every store that core makes, counted.
 *
 * `make stores` compiles core and hal with the compiler's thread-sanitizer instrumentation,
 * which calls __tsan_write2(address) and its like before each store, and links the functions of
 * stores.c instead of the sanitizer's library: they look the address up on the watched canvas.
 * In all other builds nothing is counted and TEST_STORES is 0.
 */
#ifndef TESTS_HARNESS_STORES_H
#define TESTS_HARNESS_STORES_H

#ifndef TEST_STORES
#define TEST_STORES 0
#endif

struct test_canvas;

/* Counts from now on, from zero, on this canvas and no other. */
void test_stores_watch(struct test_canvas *c);

#endif
