/* ports/microbit: BBC micro:bit, first version (nRF51822, Cortex-M0, 16 KB of RAM) with an ILI9341
 * on its edge connector. Wiring: SCK 13, MOSI 15, CS 1, D/C 2, RESET 0. Source: Nordic, nRF51
 * Series Reference Manual 3.0. */
#include "../board.h"
#include "../spi_lcd/panels.h"

#define REGISTER(address) (*(volatile uint32_t *)(uintptr_t)(address))
#define GPIO_OUTSET REGISTER(0x50000508)
#define GPIO_OUTCLR REGISTER(0x5000050C)
#define GPIO_DIRSET REGISTER(0x50000518)
#define SPI_ENABLE REGISTER(0x40003500)
#define SPI_PSELSCK REGISTER(0x40003508)
#define SPI_PSELMOSI REGISTER(0x4000350C)
#define SPI_RXD REGISTER(0x40003518)
#define SPI_TXD REGISTER(0x4000351C)
#define SPI_FREQUENCY REGISTER(0x40003524)
enum { /* numbers of pins */
    SCK = 23,
    MOSI = 21,
    PIN_CS = 2,
    PIN_DATA = 1, /* D/C */
    PIN_RESET = 3
};

static void pin_set(uint8_t pin, bool high)
{
    if (high)
        GPIO_OUTSET = UINT32_C(1) << pin;
    else
        GPIO_OUTCLR = UINT32_C(1) << pin;
}

/* At least `turns` times 4 cycles of 62.5 ns. */
static void spin(uint32_t turns)
{
    while (turns-- != 0)
        __asm__ volatile("nop");
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

/* A byte takes 16 cycles at 8 MHz, and TXD holds two; the loop is paced by spinning, because the
 * event "ready" is not emulated. Returns when the last bit is on the wire. */
static void send(const uint8_t *bytes, uint32_t n)
{
    while (n-- != 0) {
        SPI_TXD = *bytes++;
        spin(3);
        (void)SPI_RXD;
    }
    spin(8);
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
    spin((uint32_t)ms * 4000);
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

    pin_set(PIN_CS, true);
    pin_set(PIN_RESET, true);
    GPIO_DIRSET = UINT32_C(1) << SCK | UINT32_C(1) << MOSI | 1 << PIN_CS | 1 << PIN_DATA |
                  1 << PIN_RESET;
    SPI_PSELSCK = SCK;
    SPI_PSELMOSI = MOSI;
    SPI_FREQUENCY = UINT32_C(0x80000000); /* 8 MHz */
    SPI_ENABLE = 1;
    return etch_lcd_open(&lcd, &etch_ili9341, &spi, (struct etch_lcd_setup){.turn = 1}) == 0
               ? &lcd.display
               : NULL;
}
