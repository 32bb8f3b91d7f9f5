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

/* No call but wait and delay while a transfer runs, none but reset and delay outside begin .. end.
 */
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

/* Stops the DMA: what it has not moved is lost. */
static void stop(struct etch_panel_bus *b)
{
    b->left = 0;
    etch_panel_interrupt(b->panel);
}

static const enum etch_panel_fault piece_faults[] = {
    ETCH_PANEL_FAILS, ETCH_PANEL_STALLS, ETCH_PANEL_EARLY, ETCH_PANEL_LATE, ETCH_PANEL_TWICE};

/* The hardware is set up for a piece: by the thread, or by the interrupt of the piece before. */
static int start(void *context, uint8_t number, const uint8_t *bytes, uint32_t n)
{
    struct etch_panel_bus *b = context;

    if (n == 0 || (b->bus.limit != 0 && n > b->bus.limit)) {
        etch_panel_refuse(b->panel, "a piece of %lu bytes", (unsigned long)n);
    }
    if (b->left != 0) {
        etch_panel_refuse(b->panel, "a piece is started while another runs");
    }
    if (strikes(b, ETCH_PANEL_START_FAILS)) {
        etch_panel_interrupt(b->panel);
        return ETCH_PANEL_FAULT_STATUS;
    }
    b->happens = ETCH_PANEL_NO_FAULT;
    for (unsigned i = 0; i < sizeof piece_faults / sizeof piece_faults[0]; i++) {
        if (strikes(b, piece_faults[i])) {
            b->happens = piece_faults[i];
        }
    }
    b->pieces++;
    b->bytes = bytes;
    b->left = n;
    b->hash = wrap_hash(bytes, n);
    b->number = number;
    return ETCH_OK;
}

/* "Complete": the board's interrupt asks the hardware whether bytes are left, then tells. */
static void interrupt(struct etch_panel_bus *b, uint8_t number, int status)
{
    if (number == b->number && b->left != 0 && etch_transfer_runs(&b->transfer)) {
        stop(b);
        status = status < 0 ? status : ETCH_EIO;
    }
    b->ignored += !etch_transfer_done(&b->transfer, number, status);
}

static int data(const struct etch_bus *bus, struct etch_pieces *pieces)
{
    struct etch_panel_bus *b = self(bus);

    check(b, "data", true);
    return etch_transfer_start(&b->transfer, pieces);
}

/* While the thread waits: the transfer goes on by a piece, and interrupts come. */
static int pause(void *context)
{
    struct etch_panel_bus *b = context;
    const enum etch_panel_fault happens = b->happens;
    const bool breaks = happens != ETCH_PANEL_NO_FAULT && happens != ETCH_PANEL_TWICE;
    const uint8_t number = b->number;

    if (b->has_stray) {
        b->has_stray = false;
        interrupt(b, b->stray, ETCH_OK);
        return ETCH_OK;
    }
    move(b, breaks ? b->left / 2 : b->left);
    b->stray = number;
    b->has_stray = happens == ETCH_PANEL_LATE || happens == ETCH_PANEL_TWICE;
    if (happens == ETCH_PANEL_STALLS || happens == ETCH_PANEL_LATE) {
        return ETCH_EIO; /* a time out */
    }
    interrupt(b, number, happens == ETCH_PANEL_FAILS ? ETCH_PANEL_FAULT_STATUS : ETCH_OK);
    return ETCH_OK;
}

static int wait(const struct etch_bus *bus)
{
    struct etch_panel_bus *b = self(bus);
    const int status = etch_transfer_wait(&b->transfer, pause, b);

    if (b->left != 0) { /* it was given up */
        stop(b);
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
    *b = (struct etch_panel_bus){.panel = panel, .transfer = {.start = start, .context = b}};
    b->bus = (struct etch_bus){.context = b,
                               .begin = begin,
                               .end = end,
                               .command = command,
                               .data = data,
                               .wait = wait,
                               .reset = reset,
                               .delay = delay};
}
