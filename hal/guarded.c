/* hal/guarded.c: a transfer and a turn behind a monitor. Buses of ports with threads call it. See
 * guarded.h. */
#include "guarded.h"

int etch_guarded_start(struct etch_guarded *g, struct etch_pieces *pieces)
{
    int status;

    etch_monitor_enter(g->monitor);
    status = etch_transfer_start(&g->transfer, pieces);
    etch_monitor_leave(g->monitor);
    return status;
}

bool etch_guarded_done(struct etch_guarded *g, uint8_t number, int status)
{
    bool mine;

    etch_monitor_enter(g->monitor);
    mine = etch_transfer_done(&g->transfer, number, status);
    if (mine) {
        etch_monitor_signal(g->monitor); /* after a piece, too: the limit begins again */
    }
    etch_monitor_leave(g->monitor);
    return mine;
}

static int pause(void *context)
{
    const struct etch_guarded *g = context;

    return etch_monitor_wait(g->monitor, g->limit_ms);
}

int etch_guarded_wait(struct etch_guarded *g)
{
    int status;

    etch_monitor_enter(g->monitor);
    status = etch_transfer_wait(&g->transfer, pause, g);
    etch_monitor_leave(g->monitor);
    return status;
}

int etch_turn_take(struct etch_turn *turn, uint16_t limit_ms)
{
    int status = ETCH_OK;

    etch_monitor_enter(turn->monitor);
    while (turn->taken && status >= 0) {
        status = etch_monitor_wait(turn->monitor, limit_ms);
    }
    if (!turn->taken) {
        turn->taken = true;
        status = ETCH_OK;
    }
    etch_monitor_leave(turn->monitor);
    return status;
}

void etch_turn_give(struct etch_turn *turn)
{
    etch_monitor_enter(turn->monitor);
    turn->taken = false;
    etch_monitor_signal(turn->monitor);
    etch_monitor_leave(turn->monitor);
}
