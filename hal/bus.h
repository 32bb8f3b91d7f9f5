/* hal/bus.h: what a bus to a panel is.
 *
 * One constant struct of seven functions, none optional, that a board fills: SPI with a D/C line,
 * or an 8-bit parallel bus. A panel port (ports/spi_lcd) calls it; nobody else does.
 *
 *      begin | command 2A | data 00 00 01 3F | wait | .. | command 2C | data <pixels> | wait | end
 *             D/C low       D/C high                       D/C low      D/C high
 *
 * All functions run in the thread that draws; none is called from an interrupt. What data starts
 * goes on in the bus's interrupt, which asks for piece after piece and calls one function,
 * etch_transfer_done (hal/transfer.h).
 *
 * Errors: 0, or a negative number of the bus's choosing (ETCH_EIO if it has none of its own),
 * which reaches the caller of the frame loop unchanged. After any error no transfer runs; the
 * panel port calls end, and what it sends next begins with a command, which panels accept
 * wherever they were interrupted (those whose parameters are commands after a few without effect).
 */
#ifndef ETCH_HAL_BUS_H
#define ETCH_HAL_BUS_H

#include "../core/base/fixed.h"

/* Bytes on their way to a panel, piece by piece: in place, or converted as they are asked for. */
struct etch_pieces {
    /* The next piece: sets *n, at least 1 and at most the bus's limit; NULL after the last. Called
     * by the bus alone: first by data, in the thread, before anything is sent, then one call at a
     * time, from an interrupt or not. A piece stays as it is until next is called for the second
     * time after it, so one can be sent while the next is made. It may lie at an odd address.
     * Takes a few dozen instructions, or a conversion's: see ports/spi_lcd/lcd.h. */
    const uint8_t *(*next)(struct etch_pieces *pieces, uint32_t *n);
};

struct etch_bus {
    /* The board's own data, handed to nobody else. May be NULL. */
    void *context;

    /* Most bytes that a piece may have (the counter of a DMA channel); 0: any number. At least 64
     * if not 0. */
    uint32_t limit;

    /* Takes the bus for this panel: locks it against others (a card reader, a touch controller),
     * sets clock and mode, selects the panel. May block until another thread gives the bus up.
     * Held while a strip is sent, the drawing of the next one included. Fails without taking it. */
    int (*begin)(const struct etch_bus *bus);

    /* Deselects the panel and gives the bus up. Called once for every begin that succeeded, never
     * while a transfer runs. Where several workers draw a frame (workers.h), perhaps by another
     * thread than begin: then the lock is an etch_turn (guarded.h) or a semaphore. */
    void (*end)(const struct etch_bus *bus);

    /* Sends n command bytes, 1 .. 16, with D/C low, and returns when the last bit is on the wire:
     * D/C may change afterwards. The bytes are the caller's again when it returns. */
    int (*command)(const struct etch_bus *bus, const uint8_t *bytes, uint16_t n);

    /* Starts to send all pieces, at least one, with D/C high, and may return before they are out.
     * `pieces` and all that it reads belong to the bus until wait returns. The caller calls wait
     * before any other function but delay. If data fails, it has started nothing, or stopped it,
     * and asks for no more pieces. */
    int (*data)(const struct etch_bus *bus, struct etch_pieces *pieces);

    /* Returns when what data started has left the wire, at once if nothing runs; 0, or the error
     * with which it ended, reported once. It bounds the time: after a stall it stops the
     * transfer, then returns the error. An interrupt "complete" may come early (bytes left in a
     * FIFO), late or twice: hal/transfer.h sorts out the last two; against the first look at the
     * hardware's counter and busy flag, and treat bytes that are left as an error. */
    int (*wait)(const struct etch_bus *bus);

    /* Drives the panel's reset line: active (low) or not. A panel without one: does nothing; init
     * tables begin with the software reset where the controller has it. Not between begin and
     * end. */
    void (*reset)(const struct etch_bus *bus, bool active);

    /* Returns after at least ms milliseconds, 1 .. 255. May let other threads run. */
    void (*delay)(const struct etch_bus *bus, uint8_t ms);
};

#endif
