/* ports/cortex_m/exit.c: the end of a program ends the emulation, by semihosting. */
#include "../board.h"
#include "semihost.h"

void board_exit(int status)
{
    const uint32_t stopped[2] = {0x20026, (uint32_t)status}; /* ADP_Stopped_ApplicationExit */

    semihost(SYS_EXIT_EXTENDED, stopped);
}
