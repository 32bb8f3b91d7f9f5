/* ports/host/panel_bus.c: a bus to a simulated panel. The panel ports call it through hal/bus.h;
 * tests plan its faults. See panel_bus.h. */
#include "panel_bus.h"

static struct etch_panel_bus *self(const struct etch_bus *bus)
{
    return bus->context;
}

/* True at the call at which this fault is planned. */
static bool strikes(struct etch_panel_bus *b, enum etch_panel_fault fault)
{
    if (b->fault != fault || b->fault_at == 0) {
        return false;
    }
    return --b->fault_at == 0;
}

/* No call but wait and delay while a transfer runs, none but reset and delay outside begin .. end. */
static void check(struct etch_panel_bus *b, const char *call, bool taken)
{
    if (b->left != 0) {
        etch_panel_refuse(b->panel, "%s while a transfer runs", call);
    }
    if (b->taken != taken) {
        etch_panel_refuse(b->panel, taken ? "%s outside begin and end" : "%s between begin and end",
                          call);
    }
}

static int begin(const struct etch_bus *bus)
{
    struct etch_panel_bus *b = self(bus);

    check(b, "begin", false);
    if (strikes(b, ETCH_PANEL_BEGIN_FAILS)) {
        return ETCH_PANEL_FAULT_STATUS;
    }
    b->taken = true;
    etch_panel_select(b->panel, true);
    return ETCH_OK;
}

static void end(const struct etch_bus *bus)
{
    struct etch_panel_bus *b = self(bus);

    check(b, "end", true);
    b->taken = false;
    etch_panel_select(b->panel, false);
}

static int command(const struct etch_bus *bus, const uint8_t *bytes, uint16_t n)
{
    struct etch_panel_bus *b = self(bus);

    check(b, "command", true);
    if (n < 1 || n > 16) {
        etch_panel_refuse(b->panel, "%u command bytes at once", (unsigned)n);
    }
    if (strikes(b, ETCH_PANEL_COMMAND_FAILS)) {
        etch_panel_interrupt(b->panel);
        return ETCH_PANEL_FAULT_STATUS;
    }
    for (uint16_t i = 0; i < n; i++) {
        etch_panel_command(b->panel, bytes[i]);
    }
    return ETCH_OK;
}

/* ---- transfers ----------------------------------------------------------------------------- */

static uint32_t wrap_hash(const uint8_t *bytes, uint32_t n)
{
    uint32_t hash = 2166136261U;

    for (uint32_t i = 0; i < n; i++) {
        hash = etch_wrap_mul(hash ^ bytes[i], 16777619);
    }
    return hash;
}

/* The DMA: n bytes reach the panel. */
static void move(struct etch_panel_bus *b, uint32_t n)
{
    if (b->hash != 0 && wrap_hash(b->bytes, b->left) != b->hash) {
        etch_panel_refuse(b->panel, "a buffer was written to while it was sent");
    }
    b->hash = 0;
    b->left -= n;
    for (; n > 0; n--) {
        etch_panel_data(b->panel, *b->bytes++);
    }
}

static void interrupt(struct etch_panel_bus *b, uint8_t number, int status)
{
    b->ignored += !etch_transfer_done(&b->transfer, number, status);
}

static const enum etch_panel_fault transfer_faults[] = {
    ETCH_PANEL_FAILS, ETCH_PANEL_STALLS, ETCH_PANEL_EARLY, ETCH_PANEL_LATE, ETCH_PANEL_TWICE};

static int data(const struct etch_bus *bus, const uint8_t *bytes, uint32_t n)
{
    struct etch_panel_bus *b = self(bus);

    check(b, "data", true);
    if (n == 0 || (bus->limit != 0 && n > bus->limit)) {
        etch_panel_refuse(b->panel, "a transfer of %lu bytes", (unsigned long)n);
    }
    if (strikes(b, ETCH_PANEL_START_FAILS)) {
        etch_panel_interrupt(b->panel);
        return ETCH_PANEL_FAULT_STATUS;
    }
    b->happens = ETCH_PANEL_NO_FAULT;
    for (unsigned i = 0; i < sizeof transfer_faults / sizeof transfer_faults[0]; i++) {
        if (strikes(b, transfer_faults[i])) {
            b->happens = transfer_faults[i];
        }
    }
    b->bytes = bytes;
    b->left = n;
    b->hash = wrap_hash(bytes, n);
    b->number = etch_transfer_start(&b->transfer);
    if (b->happens == ETCH_PANEL_EARLY) {
        interrupt(b, b->number, ETCH_OK);
    }
    return ETCH_OK;
}

/* While the thread waits: the transfer goes on, and interrupts come. */
static int pause(void *context)
{
    struct etch_panel_bus *b = context;
    const bool breaks = b->happens != ETCH_PANEL_NO_FAULT && b->happens != ETCH_PANEL_TWICE;

    if (b->stray != 0) {
        interrupt(b, b->stray, ETCH_OK);
        b->stray = 0;
        return ETCH_OK;
    }
    move(b, breaks ? b->left / 2 : b->left);
    if (b->happens == ETCH_PANEL_STALLS || b->happens == ETCH_PANEL_LATE) {
        b->stray = b->happens == ETCH_PANEL_LATE ? b->number : 0;
        return ETCH_EIO; /* a time out */
    }
    b->stray = b->happens == ETCH_PANEL_TWICE ? b->number : 0;
    interrupt(b, b->number, breaks ? ETCH_PANEL_FAULT_STATUS : ETCH_OK);
    return ETCH_OK;
}

static int wait(const struct etch_bus *bus)
{
    struct etch_panel_bus *b = self(bus);
    int status = etch_transfer_wait(&b->transfer, pause, b);

    if (b->happens == ETCH_PANEL_EARLY) {
        move(b, b->left / 2);
    }
    if (b->left != 0) { /* the hardware's counter: stop it */
        b->left = 0;
        etch_panel_interrupt(b->panel);
        status = status < 0 ? status : ETCH_EIO;
    }
    b->happens = ETCH_PANEL_NO_FAULT;
    return status;
}

/* ---- the rest ------------------------------------------------------------------------------ */

static void reset(const struct etch_bus *bus, bool active)
{
    struct etch_panel_bus *b = self(bus);

    check(b, "reset", false);
    etch_panel_reset(b->panel, active);
}

static void delay(const struct etch_bus *bus, uint8_t ms)
{
    etch_panel_elapse(self(bus)->panel, ms * UINT64_C(1000000));
}

void etch_panel_bus_open(struct etch_panel_bus *b, struct etch_panel *panel)
{
    *b = (struct etch_panel_bus){.panel = panel};
    b->bus = (struct etch_bus){.context = b,
                               .begin = begin,
                               .end = end,
                               .command = command,
                               .data = data,
                               .wait = wait,
                               .reset = reset,
                               .delay = delay};
}
