/* tests/harness/assert.h: what ETCH_ASSERT is in `make stores`, where the compiler includes this
 * file before all of core. See test_trips in stores.h. */
#ifndef TESTS_HARNESS_ASSERT_H
#define TESTS_HARNESS_ASSERT_H

_Noreturn void test_assert_failed(const char *condition, const char *file);

#define ETCH_ASSERT(condition) ((condition) ? (void)0 : test_assert_failed(#condition, __FILE__))

#endif
