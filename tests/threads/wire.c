/* tests/threads: a bus whose DMA is a thread. The panel driver calls it through hal/bus.h. */
#include "wire.h"

static struct line *self(const struct etch_bus *bus)
{
    return bus->context;
}

/* ---- the thread: DMA channel and interrupt --------------------------------------------------- */

/* Waits for a piece; false when the wire closes. */
static bool next_piece(struct wire *w, const uint8_t **bytes, uint32_t *size, uint8_t *number)
{
    const struct etch_monitor *m = &w->monitor.monitor;
    bool open;

    m->enter(m);
    while (w->size == 0 && !w->closing)
        (void)m->wait(m, 0);
    open = w->size != 0;
    *bytes = w->bytes;
    *size = w->size;
    *number = w->number;
    w->size = 0;
    if (w->stalls != 0 && --w->stalls == 0)
        *size = 0;
    m->leave(m);
    return open;
}

static void *run(void *context)
{
    struct wire *w = context;
    const uint8_t *bytes;
    uint32_t size;
    uint8_t number;

    while (next_piece(w, &bytes, &size, &number)) {
        if (size == 0)
            continue; /* the piece that never ends */
        for (uint32_t i = 0; i < size; i++)
            etch_panel_data(w->panel, bytes[i]);
        (void)etch_guarded_done(&w->transfer, number, 0);
    }
    return NULL;
}

/* Inside the monitor. */
static int start(void *context, uint8_t number, const uint8_t *bytes, uint32_t n)
{
    struct wire *w = context;

    w->bytes = bytes;
    w->size = n;
    w->number = number;
    w->monitor.monitor.signal(&w->monitor.monitor);
    return 0;
}

/* ---- the bus --------------------------------------------------------------------------------- */

static int begin(const struct etch_bus *bus)
{
    struct line *l = self(bus);
    const int status = etch_turn_take(&l->wire->turn, 0);

    if (status < 0)
        return status;
    l->wire->panel = l->panel;
    etch_panel_select(l->panel, true);
    return 0;
}

static void end(const struct etch_bus *bus)
{
    struct line *l = self(bus);

    etch_panel_select(l->panel, false);
    etch_turn_give(&l->wire->turn);
}

static int command(const struct etch_bus *bus, const uint8_t *bytes, uint16_t n)
{
    for (; n != 0; n--)
        etch_panel_command(self(bus)->panel, *bytes++);
    return 0;
}

static int data(const struct etch_bus *bus, struct etch_pieces *pieces)
{
    return etch_guarded_start(&self(bus)->wire->transfer, pieces);
}

static int wait(const struct etch_bus *bus)
{
    struct line *l = self(bus);
    const int status = etch_guarded_wait(&l->wire->transfer);

    if (status < 0)
        etch_panel_interrupt(l->panel); /* what is half sent is lost */
    return status;
}

static void reset(const struct etch_bus *bus, bool active)
{
    etch_panel_reset(self(bus)->panel, active);
}

static void delay(const struct etch_bus *bus, uint8_t ms)
{
    etch_panel_elapse(self(bus)->panel, ms * UINT64_C(1000000));
}

bool wire_open(struct wire *w, uint16_t limit_ms)
{
    *w = (struct wire){.size = 0};
    if (!etch_pthread_monitor_open(&w->monitor))
        return false;
    w->transfer = (struct etch_guarded){.transfer = {.start = start, .context = w},
                                        .monitor = &w->monitor.monitor,
                                        .limit_ms = limit_ms};
    w->turn.monitor = &w->monitor.monitor;
    if (pthread_create(&w->thread, NULL, run, w) == 0)
        return true;
    etch_pthread_monitor_close(&w->monitor);
    return false;
}

void wire_close(struct wire *w)
{
    const struct etch_monitor *m = &w->monitor.monitor;

    m->enter(m);
    w->closing = true;
    m->signal(m);
    m->leave(m);
    (void)pthread_join(w->thread, NULL);
    etch_pthread_monitor_close(&w->monitor);
}

void line_open(struct line *l, struct wire *w, struct etch_panel *panel)
{
    *l = (struct line){.wire = w, .panel = panel};
    l->bus = (struct etch_bus){.context = l,
                               .limit = 4000, /* several pieces a strip */
                               .begin = begin,
                               .end = end,
                               .command = command,
                               .data = data,
                               .wait = wait,
                               .reset = reset,
                               .delay = delay};
}
