/* ports/rp2040/rp2040.h: what the files of this board share. */
#ifndef ETCH_PORTS_RP2040_H
#define ETCH_PORTS_RP2040_H

#include "../../hal/monitor.h"

#define REGISTER(address) (*(volatile uint32_t *)(uintptr_t)(address))

/* System and peripherals at 125 MHz, the timer in microseconds. */
void rp2040_clocks_start(void);

/* Takes blocks (bits of the RESETS block) out of reset. */
void rp2040_unreset(uint32_t blocks);

/* Keeps out the other core and interrupts: a hardware spinlock. Waiting is sleeping, until either
 * core signals. */
extern const struct etch_monitor rp2040_monitor;

/* Runs entry(context) on core 1, on a stack that ends at stack_end. Once; entry does not return.
 * ETCH_EIO if the boot ROM of core 1 does not answer within a second. */
int rp2040_core1_start(void (*entry)(void *context), void *context, uint32_t *stack_end);

/* The interrupt that ends a wait which takes too long: number 0 on core 0, 1 on core 1. */
void rp2040_alarm_interrupt(void);

#endif
