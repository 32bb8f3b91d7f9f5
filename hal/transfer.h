/* hal/transfer.h: pieces one after the other by DMA, and how their end gets from an interrupt to
 * the thread that waits. For buses that send beside the program; one that blocks needs none of it.
 *
 *      thread                                    interrupt
 *      etch_transfer_start(&t, pieces)
 *          makes pieces 0 and 1, starts 0
 *      draw the next strip                       etch_transfer_done(&t, number, 0)
 *      ..                                            starts piece 1, makes piece 2 meanwhile
 *      etch_transfer_wait(&t, pause, context)    .. the last: it has ended
 *                                                (RTOS: give the semaphore)
 *
 * Pieces are numbered, so that a completion that comes late, after its transfer was given up, or
 * twice, ends nothing that follows, if the interrupt knows whose it is: a driver that hands a
 * word of the user's to its callback does; a plain one asks the hardware whether the channel is
 * done, and passes the number that `start` was given last. (Numbers repeat after 256.)
 *
 * No locks: each field has one writer at a time, also where 16 bits are not written at once.
 * Thread and interrupt run on one core (else, and for a task that sleeps: hal/guarded.h); the
 * compiler is kept from moving what is written to the pieces across start and wait. What the DMA
 * sees is the board's affair: before it starts the channel it drains the write buffer (DSB on
 * Cortex-M) and, where data are cached, cleans the lines of the piece; none is ever invalidated,
 * as panels are only written to.
 */
#ifndef ETCH_HAL_TRANSFER_H
#define ETCH_HAL_TRANSFER_H

#include "bus.h"

/* Set start and context, the rest 0; that is private. */
struct etch_transfer {
    /* Starts the hardware on n bytes, and returns at once: 0, or a negative number, which ends the
     * transfer. Called in the thread for the first piece, in the interrupt for the others. Its
     * completion is to be reported as `number`, later, not from within. */
    int (*start)(void *context, uint8_t number, const uint8_t *bytes, uint32_t n);
    void *context;

    /* The thread's until the first piece is started, then the interrupt's: */
    struct etch_pieces *pieces;
    const uint8_t *ahead; /* the piece that comes next, or NULL */
    uint32_t ahead_size;  /* its bytes */
    volatile uint8_t number;
    volatile bool runs;
    volatile int status; /* with which it ended */
};

/* Thread: sends all pieces. 0, or the error of `start`. None may be running. */
int etch_transfer_start(struct etch_transfer *t, struct etch_pieces *pieces);

/* Interrupt or thread: piece `number` is out (status 0), or failed. Starts the next, or ends the
 * transfer. The one call that is safe in an interrupt, and at one priority only. False, and
 * without effect, if it is not the piece that runs. */
bool etch_transfer_done(struct etch_transfer *t, uint8_t number, int status);

ETCH_INLINE bool etch_transfer_runs(const struct etch_transfer *t)
{
    return t->runs;
}

/* Thread: returns the status with which the transfer ended; 0 if none runs. Calls pause as long
 * as one runs. pause returns 0 after an interrupt or sooner, or a negative number to give up,
 * best after several times the time the transfer needs: then the transfer counts as ended, that
 * number is returned, and the caller stops the hardware. Bare metal pauses by WFE, which misses no
 * interrupt (WFI can miss one and sleep until the next, say the tick's); an RTOS takes the
 * semaphore, and one that is left over from an earlier transfer does no harm. */
int etch_transfer_wait(struct etch_transfer *t, int (*pause)(void *context), void *context);

#endif
