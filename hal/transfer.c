/* hal/transfer.c: pieces one after the other, and their end from interrupt to thread. Buses call
 * it. See transfer.h. */
#include "transfer.h"

/* The compiler moves no store or load across; the volatile fields alone would not stop it. */
#if defined(__GNUC__)
#define BARRIER() __asm__ volatile("" : : : "memory")
#else
#define BARRIER() ((void)0)
#endif

/* Starts a piece under a number of its own. */
static int start(struct etch_transfer *t, const uint8_t *bytes, uint32_t n)
{
    t->number = (uint8_t)((t->number + 1) & 0xFF);
    return t->start(t->context, t->number, bytes, n);
}

int etch_transfer_start(struct etch_transfer *t, struct etch_pieces *pieces)
{
    uint32_t n = 0;
    const uint8_t *bytes;
    int status;

    ETCH_ASSERT(t != NULL && t->start != NULL && pieces != NULL && !t->runs);
    bytes = pieces->next(pieces, &n);
    ETCH_ASSERT(bytes != NULL);
    /* The second piece is made now: the interrupt may come before `start` returns. */
    t->pieces = pieces;
    t->ahead = pieces->next(pieces, &t->ahead_size);
    t->status = ETCH_OK;
    BARRIER();
    t->runs = true;
    status = start(t, bytes, n);
    if (status < 0) {
        t->runs = false;
    }
    return status;
}

bool etch_transfer_done(struct etch_transfer *t, uint8_t number, int status)
{
    if (!t->runs || number != t->number) {
        return false;
    }
    if (status >= 0 && t->ahead != NULL) {
        status = start(t, t->ahead, t->ahead_size);
        if (status >= 0) {
            t->ahead = t->pieces->next(t->pieces, &t->ahead_size);
            return true;
        }
    }
    t->status = status; /* before `runs`, which lets the thread read it */
    BARRIER();
    t->runs = false;
    return true;
}

int etch_transfer_wait(struct etch_transfer *t, int (*pause)(void *context), void *context)
{
    int status = ETCH_OK;

    while (t->runs && status >= 0) {
        status = pause(context);
    }
    if (status < 0) {
        t->runs = false; /* a completion that comes from now on is late */
    } else {
        status = t->status;
    }
    t->status = ETCH_OK;
    BARRIER();
    return status;
}
