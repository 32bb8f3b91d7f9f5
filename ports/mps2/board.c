/* ports/mps2: Arm MPS2 with the images AN385 (Cortex-M3) and AN386 (M4). The panel is an ILI9341 on
 * the SPI of the board's LCD connector; its control pins are bits of a register of the FPGA.
 * board.mk gives some images another panel. Source: Arm, Application Notes AN385 and AN386. */
#include "../board.h"
#include "../spi_lcd/panels.h"

#ifndef MPS2_PANEL
#define MPS2_PANEL etch_ili9341
#define MPS2_TURN 1
#endif
#define REGISTER(address) (*(volatile uint32_t *)(uintptr_t)(address))

/* PL022 serial port of the LCD connector. */
#define SSP_CR0 REGISTER(0x40021000)
#define SSP_CR1 REGISTER(0x40021004)
#define SSP_DR REGISTER(0x40021008)
#define SSP_SR REGISTER(0x4002100C)
#define SSP_CPSR REGISTER(0x40021010)
enum {
    SSP_8_BITS = 7,
    SSP_ENABLE = 2,
    SSP_ROOM = 2, /* in the transmit FIFO */
    SSP_RECEIVED = 4,
    SSP_BUSY = 16
};

/* MISC register of the FPGA: the pins of the LCD connector. */
#define PINS REGISTER(0x4002804C)
enum {
    PIN_CS = 1,
    PIN_RESET = 8,
    PIN_BACKLIGHT = 64,
    PIN_DATA = 16 /* D/C */
};

#define TICKS_100_HZ REGISTER(0x40028014) /* counts up */

static void pin_set(uint32_t pin, bool high)
{
    PINS = high ? PINS | pin : PINS & ~pin;
}

static int begin(const struct etch_bus *bus)
{
    (void)bus;
    pin_set(PIN_CS, false);
    return 0;
}

static void end(const struct etch_bus *bus)
{
    (void)bus;
    pin_set(PIN_CS, true);
}

/* Returns when the last bit is on the wire. What comes in meanwhile is taken out: QEMU's port stops
 * when its receive FIFO is full. */
static void send(const uint8_t *bytes, uint32_t n)
{
    while (n-- != 0) {
        while ((SSP_SR & SSP_ROOM) == 0) {
        }
        SSP_DR = *bytes++;
        while ((SSP_SR & SSP_RECEIVED) == 0) {
        }
        (void)SSP_DR;
    }
    while ((SSP_SR & SSP_BUSY) != 0) {
    }
}

static int command(const struct etch_bus *bus, const uint8_t *bytes, uint16_t n)
{
    (void)bus;
    pin_set(PIN_DATA, false);
    send(bytes, n);
    return 0;
}

static int data(const struct etch_bus *bus, struct etch_pieces *pieces)
{
    const uint8_t *bytes;
    uint32_t n;

    (void)bus;
    pin_set(PIN_DATA, true);
    while ((bytes = pieces->next(pieces, &n)) != NULL) {
        send(bytes, n);
    }
    return 0;
}

static int wait(const struct etch_bus *bus)
{
    (void)bus;
    return 0;
}

static void reset(const struct etch_bus *bus, bool active)
{
    (void)bus;
    pin_set(PIN_RESET, !active);
}

static void delay(const struct etch_bus *bus, uint8_t ms)
{
    const uint32_t start = TICKS_100_HZ, ticks = (uint32_t)(ms + 9) / 10 + 1;

    (void)bus;
    while (TICKS_100_HZ - start < ticks) {
    }
}

static const struct etch_bus spi = {.begin = begin,
                                    .end = end,
                                    .command = command,
                                    .data = data,
                                    .wait = wait,
                                    .reset = reset,
                                    .delay = delay};

const struct etch_display *board_open(void)
{
    static struct etch_lcd lcd;
    static uint8_t scratch[128]; /* for panels that take other pixels */
    const struct etch_lcd_setup setup = {
        .scratch = scratch, .scratch_size = sizeof scratch, .turn = MPS2_TURN};

    PINS = PIN_CS | PIN_RESET | PIN_BACKLIGHT;
    SSP_CR0 = SSP_8_BITS;
    SSP_CPSR = 2; /* 12.5 MHz */
    SSP_CR1 = SSP_ENABLE;
    return etch_lcd_open(&lcd, &MPS2_PANEL, &spi, setup) == 0 ? &lcd.display : NULL;
}
