/* ports/cortex_m/systick.h: waiting by the core's own timer, for boards that have no other. */
#ifndef ETCH_PORTS_CORTEX_M_SYSTICK_H
#define ETCH_PORTS_CORTEX_M_SYSTICK_H

#include "../../core/base/fixed.h"

/* Returns after at least ms milliseconds; `hz` is the core's clock, below 4 GHz. Takes the timer
 * for itself while it waits. */
ETCH_INLINE void systick_delay(uint32_t hz, uint8_t ms)
{
    volatile uint32_t *const control = (volatile uint32_t *)(uintptr_t)UINT32_C(0xE000E010);

    control[1] = hz / 1000 - 1; /* reload */
    control[2] = 0;             /* current value */
    control[0] = 5;             /* core clock, no interrupt */
    for (uint16_t left = ms; left != 0;)
        if ((control[0] & UINT32_C(0x10000)) != 0) /* reached zero; reading clears */
            left--;
    control[0] = 0;
}

#endif
