/* tests/cli: the suites of host-test. */
#include "tests/harness/harness.h"

void suite_decimal(void);
void suite_dump(void);
void suite_fragments(void);
void suite_obj(void);
void suite_screen(void);

extern const struct test_suite test_suites[];
const struct test_suite test_suites[] = {{"decimal", suite_decimal},     {"dump", suite_dump},
                                         {"fragments", suite_fragments}, {"obj", suite_obj},
                                         {"screen", suite_screen},       {0, 0}};
