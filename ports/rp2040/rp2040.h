/* ports/rp2040/rp2040.h: what the files of this board share. */
#ifndef ETCH_PORTS_RP2040_H
#define ETCH_PORTS_RP2040_H

#include "../../core/base/fixed.h"

#define REGISTER(address) (*(volatile uint32_t *)(uintptr_t)(address))

/* System and peripherals at 125 MHz, the timer in microseconds. */
void rp2040_clocks_start(void);

/* Takes blocks (bits of the RESETS block) out of reset. */
void rp2040_unreset(uint32_t blocks);

#endif
