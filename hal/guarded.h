/* hal/guarded.h: what threads and interrupts share, behind a monitor (hal/monitor.h): a transfer,
 * and a turn.
 *
 * A transfer of hal/transfer.h whose interrupt runs on another core, or ends the sleep of a task:
 *
 *      task                                        interrupt
 *      etch_guarded_start(&g, pieces)
 *      draw the next strip                         etch_guarded_done(&g, number, 0)
 *      etch_guarded_wait(&g)      sleeps until     .. the last: signals
 */
#ifndef ETCH_HAL_GUARDED_H
#define ETCH_HAL_GUARDED_H

#include "monitor.h"
#include "transfer.h"

/* Set transfer.start, transfer.context, monitor and limit_ms; the rest is 0 and private. `start`
 * and the pieces' `next` are called inside the monitor. */
struct etch_guarded {
    struct etch_transfer transfer;
    const struct etch_monitor *monitor;
    uint16_t limit_ms; /* that one piece may take, 1 .. 65535; 0: no limit */
};

/* As etch_transfer_start. Task only. */
int etch_guarded_start(struct etch_guarded *g, struct etch_pieces *pieces);

/* As etch_transfer_done. Interrupt or task. */
bool etch_guarded_done(struct etch_guarded *g, uint8_t number, int status);

/* As etch_transfer_wait, asleep meanwhile: the status with which the transfer ended, or the
 * monitor's if nothing was signalled for limit_ms. Task only; need not be the one that started. */
int etch_guarded_wait(struct etch_guarded *g);

/* A turn: one thread has it at a time, for as long as it likes, and another may give it back. What
 * a bus needs that two panels share: begin takes it and end gives it, which may be called by
 * another worker of hal/workers.h. Set monitor, the rest 0. */
struct etch_turn {
    const struct etch_monitor *monitor;
    bool taken;
};

/* Waits until it is free. 0, or the monitor's status after limit_ms; it is not taken then. */
int etch_turn_take(struct etch_turn *turn, uint16_t limit_ms);
void etch_turn_give(struct etch_turn *turn);

#endif
