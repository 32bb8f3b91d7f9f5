/* tests/threads: a bus whose transfers are made by a thread of its own, which stands in for a DMA
 * channel and its interrupt: it moves bytes to a simulated panel while the program draws, then
 * says that they are out. Several panels may hang on one wire; begin waits for its turn. */
#ifndef TESTS_THREADS_WIRE_H
#define TESTS_THREADS_WIRE_H

#include "hal/guarded.h"
#include "ports/host/panel.h"
#include "ports/pthread/pthread_monitor.h"

struct wire {
    struct etch_pthread_monitor monitor;
    struct etch_guarded transfer;
    struct etch_turn turn;
    pthread_t thread;

    /* Inside the monitor: the piece to move, if size is not 0. */
    const uint8_t *bytes;
    uint32_t size;
    uint8_t number;
    bool closing;
    int stalls; /* pieces from now on until one never ends, from 1; 0: none does */

    struct etch_panel *panel; /* that is selected: whose turn it is */
};

/* A panel on the wire. Give &line.bus to etch_lcd_open. */
struct line {
    struct etch_bus bus;
    struct wire *wire;
    struct etch_panel *panel;
};

/* False: no thread to be had. */
bool wire_open(struct wire *wire, uint16_t limit_ms);
void wire_close(struct wire *wire);

void line_open(struct line *line, struct wire *wire, struct etch_panel *panel);

#endif
