/* tests/harness: the project's own small test runner.
 *
 * A file tests/unit/NAME.c defines `void suite_NAME(void)`, which RUNs its cases; the makefile
 * collects the suites. A case fails if one of its CHECKs does; the first few failures of a case
 * are printed. Uses no libc, so that it also runs on a target: the port gives test_write.
 *
 * canvas.h has the guarded surface and the ASCII pictures, ../oracle the slow exact answers.
 */
#ifndef TESTS_HARNESS_H
#define TESTS_HARNESS_H

#include <stdbool.h>
#include <stdint.h>

/* Every seeded loop runs TEST_COUNT(n) times: n / TEST_DIVISOR. The divisor is 1 on the host and
 * larger in builds that are slow (sanitizers, counted stores, emulators); no case is left out. */
#ifndef TEST_DIVISOR
#define TEST_DIVISOR 1
#endif
#define TEST_COUNT(n) ((INT32_C(n) + TEST_DIVISOR - 1) / TEST_DIVISOR)

/* Runs one case and counts it. */
#define RUN(function) test_run(#function, function)
void test_run(const char *name, void (*function)(void));

/* Fails the running case, with the values, unless the condition holds. Goes on. */
#define CHECK(condition) test_check((condition), #condition, __FILE__, __LINE__)
#define CHECK_EQ(actual, expected)                                                                 \
    test_check_eq((int64_t)(actual), (int64_t)(expected), #actual " == " #expected, __FILE__,      \
                  __LINE__)
bool test_check(bool ok, const char *text, const char *file, int line);
bool test_check_eq(int64_t actual, int64_t expected, const char *text, const char *file, int line);

/* After a failed CHECK: one value that helps to reproduce it. */
void test_note(const char *name, int64_t value);

/* Prints a line of text, and a labelled count ("200000 triangles, no differing pixel"). */
void test_print(const char *text);
void test_print_count(const char *before, int64_t n, const char *after);

/* True once the running case has failed: stop comparing after the first difference. */
bool test_failed(void);

struct test_suite {
    const char *name;
    void (*run)(void);
};

/* Runs all suites, prints "N passed, N failed", returns 0 iff none failed. `only`: NULL or the
 * name of a single suite. */
int test_main(const char *only);

/* Seeded random numbers (xorshift32); equal on every machine. */
uint32_t test_random(uint32_t *state);
/* Uniform in lo .. hi, inclusive. */
int32_t test_range(uint32_t *state, int32_t lo, int32_t hi);

/* Given by the port: writes text to the person who runs the tests. */
void test_write(const char *text);

#endif
