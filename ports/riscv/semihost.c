/* ports/riscv/semihost.c: text and the end of a program, told to a debugger or an emulator by three
 * instructions that it knows by their looks; without one the breakpoint stops a real core. Source:
 * RISC-V International, RISC-V Semihosting. */
#include "../board.h"

static void semihost(uintptr_t operation, uintptr_t argument)
{
    register uintptr_t a0 __asm__("a0") = operation;
    register uintptr_t a1 __asm__("a1") = argument;

    __asm__ volatile(".balign 16\n"
                     ".option push\n"
                     ".option norvc\n"
                     "slli zero, zero, 0x1f\n"
                     "ebreak\n"
                     "srai zero, zero, 7\n"
                     ".option pop\n"
                     : "+r"(a0)
                     : "r"(a1)
                     : "memory");
}

void board_print(const char *text)
{
    semihost(4, (uintptr_t)text); /* SYS_WRITE0 */
}

void board_exit(int status)
{
    semihost(0x18, status == 0 ? 0x20026 : 0x20023); /* SYS_EXIT: of an application, or an error */
}
