/* tests/cli: the suites of host-test. */
#include "tests/harness/harness.h"

void suite_decimal(void);
void suite_dump(void);
void suite_obj(void);

extern const struct test_suite test_suites[];
const struct test_suite test_suites[] = {
    {"decimal", suite_decimal}, {"dump", suite_dump}, {"obj", suite_obj}, {0, 0}};
