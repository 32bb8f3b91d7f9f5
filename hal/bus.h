/* hal/bus.h: what a bus to a panel is.
 *
 * One constant struct of seven functions, none optional, that a board fills: SPI with a D/C line,
 * or an 8-bit parallel bus. A panel port (ports/spi_lcd) calls it; nobody else does.
 *
 *      begin | command 2A | data 00 00 01 3F | wait | .. | command 2C | data <pixels> | wait | end
 *             D/C low       D/C high                       D/C low      D/C high
 *
 * All functions but the interrupt of the transfer run in the thread that draws; none is called
 * from an interrupt. An interrupt calls one function, etch_transfer_done (hal/transfer.h).
 *
 * Errors: 0, or a negative number of the bus's choosing (ETCH_EIO if it has none of its own),
 * which reaches the caller of the frame loop unchanged. After any error no transfer runs; the
 * panel port calls end, and what it sends next begins with a command, which panels accept
 * wherever they were interrupted.
 */
#ifndef ETCH_HAL_BUS_H
#define ETCH_HAL_BUS_H

#include "../core/base/fixed.h"

struct etch_bus {
    /* The board's own data, handed to nobody else. May be NULL. */
    void *context;

    /* Most bytes that one call of data takes (the counter of a DMA channel); 0: any number. The
     * panel port splits what is longer. At least 64 if not 0. */
    uint32_t limit;

    /* Takes the bus for this panel: locks it against others (a card reader, a touch controller),
     * sets clock and mode, selects the panel. May block until another thread gives the bus up.
     * Held while a strip is sent, the drawing of the next one included. Fails without taking it. */
    int (*begin)(const struct etch_bus *bus);

    /* Deselects the panel and gives the bus up. Called once for every begin that succeeded, never
     * while a transfer runs. */
    void (*end)(const struct etch_bus *bus);

    /* Sends n command bytes, 1 .. 16, with D/C low, and returns when the last bit is on the wire:
     * D/C may change afterwards. The bytes are the caller's again when it returns. */
    int (*command)(const struct etch_bus *bus, const uint8_t *bytes, uint16_t n);

    /* Starts to send n >= 1 bytes with D/C high, and may return before they are out. The bytes
     * belong to the bus until wait returns: it may read but not change them. The address may be
     * odd. The caller calls wait before any other function but delay. If it fails, it has
     * started nothing, or stopped it. */
    int (*data)(const struct etch_bus *bus, const uint8_t *bytes, uint32_t n);

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
