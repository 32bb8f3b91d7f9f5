/* ports/hifive1: SiFive HiFive1 (FE310, rv32imac, 16 KB of RAM) on the clock after reset, with an
 * ILI9341 on SPI1. Wiring: SCK 13, MOSI 11, CS 10, D/C 9, RESET 8. Source: SiFive, FE310 manual. */
#include "../board.h"
#include "../spi_lcd/panels.h"

#define REGISTER(address) (*(volatile uint32_t *)(uintptr_t)(address))
#define GPIO_OUTPUT_ENABLE REGISTER(0x10012008)
#define GPIO_OUTPUT REGISTER(0x1001200C)
#define GPIO_FUNCTION REGISTER(0x10012038)
#define SPI1_DIVIDER REGISTER(0x10024000)
#define SPI1_SELECT_MODE REGISTER(0x10024018)
#define SPI1_FORMAT REGISTER(0x10024040)
#define SPI1_SEND REGISTER(0x10024048)
#define SPI1_RECEIVE REGISTER(0x1002404C)
#define TICKS_32768_HZ REGISTER(0x0200BFF8)
enum { /* of the port */
    PIN_RESET = 1 << 0,
    PIN_DATA = 1 << 1, /* D/C */
    PIN_CS = 1 << 2,
    PINS_SPI = 1 << 3 | 1 << 5,
    FULL = 31, /* bits of SEND and RECEIVE */
    EMPTY = 31
};

static void pin_set(uint32_t pin, bool high)
{
    GPIO_OUTPUT = high ? GPIO_OUTPUT | pin : GPIO_OUTPUT & ~pin;
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

/* Returns when the last bit is on the wire: a byte has come in for each that went out. */
static void send(const uint8_t *bytes, uint32_t n)
{
    while (n-- != 0) {
        while (SPI1_SEND >> FULL != 0) {
        }
        SPI1_SEND = *bytes++;
        while (SPI1_RECEIVE >> EMPTY != 0) {
        }
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
    (void)bus;
    for (const uint32_t began = TICKS_32768_HZ; TICKS_32768_HZ - began <= 33 * (uint32_t)ms;) {
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

    pin_set(PIN_CS | PIN_RESET, true);
    GPIO_OUTPUT_ENABLE |= PIN_CS | PIN_DATA | PIN_RESET;
    GPIO_FUNCTION |= PINS_SPI;
    SPI1_DIVIDER = 0;                /* half the core's clock */
    SPI1_SELECT_MODE = 3;            /* the select line is a pin */
    SPI1_FORMAT = UINT32_C(8) << 16; /* 8 bits, highest first, received too */
    return etch_lcd_open(&lcd, &etch_ili9341, &spi, (struct etch_lcd_setup){.turn = 1}) == 0
               ? &lcd.display
               : NULL;
}
