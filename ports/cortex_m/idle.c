/* ports/cortex_m/idle.c: at the end of a program the board goes on to show its screen. */
#include "../board.h"

void board_exit(int status)
{
    (void)status;
    for (;;)
        __asm__ volatile("wfi");
}
