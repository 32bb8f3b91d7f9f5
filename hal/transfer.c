/* hal/transfer.c: the end of a transfer, from interrupt to thread. Buses call it. See
 * transfer.h. */
#include "transfer.h"

uint8_t etch_transfer_start(struct etch_transfer *t)
{
    const uint8_t number = (uint8_t)((t->started + 1) & 0xFF);

    ETCH_ASSERT(!etch_transfer_runs(t));
    t->status = ETCH_OK;
    t->started = number; /* runs from here on */
    return number;
}

bool etch_transfer_done(struct etch_transfer *t, uint8_t number, int status)
{
    if (number != t->started || t->ended == number) {
        return false;
    }
    t->status = status; /* before `ended`, which lets the thread read it */
    t->ended = number;
    return true;
}

int etch_transfer_wait(struct etch_transfer *t, int (*pause)(void *context), void *context)
{
    int status = ETCH_OK;

    while (etch_transfer_runs(t) && status >= 0) {
        status = pause(context);
    }
    if (status < 0) {
        /* A number that no interrupt has: one that comes from now on is late. */
        t->started = (uint8_t)((t->started + 1) & 0xFF);
        t->ended = t->started;
    } else {
        status = t->status;
    }
    t->status = ETCH_OK;
    return status;
}
