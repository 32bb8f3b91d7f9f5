/* hal/transfer.h: how the end of a transfer gets from an interrupt to the thread that waits.
 *
 *      thread                                     interrupt
 *      number = etch_transfer_start(&t)
 *      start the DMA                              ..
 *      draw the next strip                        etch_transfer_done(&t, number, 0)
 *      status = etch_transfer_wait(&t, pause, c)  (RTOS: give the semaphore)
 *
 * Transfers are numbered, so that a completion that comes late, after its transfer was given up,
 * or twice, does not end the transfer that follows. (Numbers repeat after 256.) Each field has
 * one writer at a time and needs no lock, also where 16 bits are not written at once. Thread and
 * interrupt run on one core.
 */
#ifndef ETCH_HAL_TRANSFER_H
#define ETCH_HAL_TRANSFER_H

#include "../core/base/fixed.h"

/* Zero it before use; then private. */
struct etch_transfer {
    volatile uint8_t started; /* number of the last transfer: the thread's */
    volatile uint8_t ended;   /* equal to started: none runs. The interrupt's while one runs */
    volatile int status;      /* with which it ended */
};

/* Thread: before the hardware is started. Returns the number to hand to the interrupt. None may
 * be running. */
uint8_t etch_transfer_start(struct etch_transfer *t);

/* Interrupt or thread: transfer `number` has ended with `status`, 0 or negative. The one call
 * that is safe in an interrupt. False, and without effect, if it is not the one that runs. */
bool etch_transfer_done(struct etch_transfer *t, uint8_t number, int status);

ETCH_INLINE bool etch_transfer_runs(const struct etch_transfer *t)
{
    return t->started != t->ended;
}

/* Thread: returns the status with which the transfer ended; 0 if none runs. Calls pause as long
 * as one runs. pause returns 0 after an interrupt or sooner (bare metal: WFE, or WFI with
 * interrupts masked, which cannot miss one; an RTOS takes the semaphore), or a negative number
 * to give up, best after several times the time the transfer needs: then the transfer counts as
 * ended, that number is returned, and the caller stops the hardware. */
int etch_transfer_wait(struct etch_transfer *t, int (*pause)(void *context), void *context);

#endif
