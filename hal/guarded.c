/* hal/guarded.c: a transfer and a turn behind a monitor. Buses of ports with threads call it. See
 * guarded.h. */
#include "guarded.h"

int etch_guarded_start(struct etch_guarded *g, struct etch_pieces *pieces)
{
    int status;

    g->monitor->enter(g->monitor);
    status = etch_transfer_start(&g->transfer, pieces);
    g->monitor->leave(g->monitor);
    return status;
}

bool etch_guarded_done(struct etch_guarded *g, uint8_t number, int status)
{
    bool mine;

    g->monitor->enter(g->monitor);
    mine = etch_transfer_done(&g->transfer, number, status);
    if (mine) {
        g->monitor->signal(g->monitor); /* after a piece, too: the limit begins again */
    }
    g->monitor->leave(g->monitor);
    return mine;
}

static int pause(void *context)
{
    const struct etch_guarded *g = context;

    return g->monitor->wait(g->monitor, g->limit_ms);
}

int etch_guarded_wait(struct etch_guarded *g)
{
    int status;

    g->monitor->enter(g->monitor);
    status = etch_transfer_wait(&g->transfer, pause, g);
    g->monitor->leave(g->monitor);
    return status;
}

int etch_turn_take(struct etch_turn *turn, uint16_t limit_ms)
{
    int status = ETCH_OK;

    turn->monitor->enter(turn->monitor);
    while (turn->taken && status >= 0) {
        status = turn->monitor->wait(turn->monitor, limit_ms);
    }
    if (!turn->taken) {
        turn->taken = true;
        status = ETCH_OK;
    }
    turn->monitor->leave(turn->monitor);
    return status;
}

void etch_turn_give(struct etch_turn *turn)
{
    turn->monitor->enter(turn->monitor);
    turn->taken = false;
    turn->monitor->signal(turn->monitor);
    turn->monitor->leave(turn->monitor);
}
