/* ports/freertos/mps2.h: the board of ports/mps2 under FreeRTOS: its panel, with strips that go out
 * by interrupts while the task draws. */
#ifndef ETCH_PORTS_FREERTOS_MPS2_H
#define ETCH_PORTS_FREERTOS_MPS2_H

#include "../spi_lcd/lcd.h"
#include "freertos_monitor.h"

/* Brings up the panel. Call it before the scheduler. NULL if it failed. */
const struct etch_display *mps2_open(void);

/* Interrupts that ended a transfer so far. */
extern volatile uint32_t mps2_transfers;

/* A failed configASSERT. */
void mps2_stop(void);

#endif
