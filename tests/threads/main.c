/* tests/threads: threads SCENE SCENE ..: all that is to run under ThreadSanitizer. */
#include <stddef.h>
#include <stdio.h>

#include "tests/harness/harness.h"
#include "threads.h"

const char *const *scene_paths;
int scene_count;

extern const struct test_suite test_suites[];
const struct test_suite test_suites[] = {
    {"tasks", suite_tasks}, {"workers", suite_workers}, {NULL, NULL}};

void test_write(const char *text)
{
    fputs(text, stdout);
    fflush(stdout);
}

int main(int argc, char **argv)
{
    if (argc < 3) {
        fputs("usage: threads SCENE SCENE ..\n", stderr);
        return 2;
    }
    scene_paths = (const char *const *)argv + 1;
    scene_count = argc - 1;
    return test_main(NULL);
}
