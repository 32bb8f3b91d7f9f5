/* ports/cortex_m/print.c: text by semihosting, for boards without a line of their own. */
#include "../board.h"
#include "semihost.h"

void board_print(const char *text)
{
    semihost(SYS_WRITE0, text);
}
