/* tests/targets: the unit tests as a firmware: text by board_print, the status by board_exit. */
#include <stddef.h>

#include "ports/board.h"
#include "tests/harness/harness.h"

int main(void);

void test_write(const char *text)
{
    board_print(text);
}

int main(void)
{
    return test_main(NULL);
}
