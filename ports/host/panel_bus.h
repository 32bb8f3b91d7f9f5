/* ports/host/panel_bus.h: a bus (hal/bus.h) to a simulated panel, with transfers that run beside
 * the program like DMA, and with faults.
 *
 * A transfer takes place at the last moment, when it is waited for, so a buffer that is drawn on
 * too early is seen: each piece is compared with what it held when it was started, and those not
 * yet started show what the buffer holds by then. Interrupts start piece after piece. Calls that
 * hal/bus.h forbids are refused like those that the panel's data sheet forbids, in
 * panel->error. */
#ifndef ETCH_HOST_PANEL_BUS_H
#define ETCH_HOST_PANEL_BUS_H

#include "../../hal/bus.h"
#include "../../hal/transfer.h"
#include "panel.h"

/* What goes wrong, at the k-th call or piece. All but the first three let half of a piece's bytes
 * through. */
enum etch_panel_fault {
    ETCH_PANEL_NO_FAULT,
    ETCH_PANEL_BEGIN_FAILS,   /* the bus cannot be had */
    ETCH_PANEL_COMMAND_FAILS, /* nothing is sent */
    ETCH_PANEL_START_FAILS,   /* a piece is not started */
    ETCH_PANEL_FAILS,         /* it ends with an error */
    ETCH_PANEL_STALLS,        /* it never ends */
    ETCH_PANEL_EARLY,         /* "complete" comes with half of the bytes left */
    ETCH_PANEL_LATE,          /* "complete" comes after it was given up, during the next one */
    ETCH_PANEL_TWICE          /* it ends well, and "complete" comes again during the next one */
};

enum {
    ETCH_PANEL_FAULT_STATUS = -77 /* with which a faulty call fails; a stall: ETCH_EIO */
};

struct etch_panel_bus {
    struct etch_bus bus; /* its context is this struct */
    struct etch_panel *panel;
    struct etch_transfer transfer;

    enum etch_panel_fault fault;
    uint32_t fault_at; /* calls of that kind from now on until it happens, from 1; once */
    uint32_t ignored;  /* completions that came when their piece did not run */
    uint32_t pieces;   /* started so far, by the thread or by interrupts */

    /* The piece that runs. */
    const uint8_t *bytes;
    uint32_t left, hash;
    uint8_t number, stray; /* stray: the number of a completion still to come, if has_stray */
    bool has_stray;
    enum etch_panel_fault happens;
    bool taken;
};

/* Connects a panel. Both must stay where they are. */
void etch_panel_bus_open(struct etch_panel_bus *bus, struct etch_panel *panel);

#endif
