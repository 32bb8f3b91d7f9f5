/* ports/cortex_m/semihost.h: calls to a debugger or an emulator. Without one the breakpoint stops a
 * real core. Source: Arm, Semihosting for AArch32 and AArch64. */
#ifndef ETCH_PORTS_CORTEX_M_SEMIHOST_H
#define ETCH_PORTS_CORTEX_M_SEMIHOST_H

#include "../../core/base/fixed.h"

enum {
    SYS_WRITE0 = 4,
    SYS_EXIT_EXTENDED = 0x20
};

ETCH_INLINE void semihost(uint32_t operation, const void *argument)
{
    register uint32_t r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;

    __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
}

#endif
