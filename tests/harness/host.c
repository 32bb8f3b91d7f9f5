/* tests/harness: the tests on a developer's machine. Usage: unit-test [SUITE] */
#include <stddef.h>
#include <stdio.h>

#include "harness.h"

void test_write(const char *text)
{
    fputs(text, stdout);
    fflush(stdout);
}

int main(int argc, char **argv)
{
    return test_main(argc > 1 ? argv[1] : NULL);
}
