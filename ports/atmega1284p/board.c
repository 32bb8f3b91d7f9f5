/* ports/atmega1284p: an ATmega1284P at 16 MHz (8-bit core, 16-bit int, 16 KB of RAM) with an ST7735
 * of 160 x 128. Wiring: SCK PB7, MOSI PB5, CS PB4, D/C PB1, RESET PB0; text on the first serial
 * port. Start-up is avr-libc's. Source: Microchip, ATmega1284P data sheet. */
#include "../board.h"
#include "../spi_lcd/panels.h"

#define REGISTER(address) (*(volatile uint8_t *)(uintptr_t)(address))
#define DDRB REGISTER(0x24)
#define PORTB REGISTER(0x25)
#define SPCR REGISTER(0x4C)
#define SPSR REGISTER(0x4D)
#define SPDR REGISTER(0x4E)
#define UCSR0A REGISTER(0xC0)
#define UCSR0B REGISTER(0xC1)
#define UDR0 REGISTER(0xC6)
enum { /* pins of port B */
    PIN_RESET = 1 << 0,
    PIN_DATA = 1 << 1, /* D/C */
    PIN_CS = 1 << 4,
    PIN_MOSI = 1 << 5,
    PIN_SCK = 1 << 7
};

static void pin_set(uint8_t pin, bool high)
{
    PORTB = (uint8_t)(high ? PORTB | pin : PORTB & ~pin);
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

/* Returns when the last bit is on the wire. */
static void send(const uint8_t *bytes, uint32_t n)
{
    for (; n != 0; n--) {
        SPDR = *bytes++;
        while ((SPSR & 0x80) == 0) {
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

/* A turn of the inner loop takes four cycles or more of 62.5 ns. */
static void delay(const struct etch_bus *bus, uint8_t ms)
{
    (void)bus;
    for (; ms != 0; ms--)
        for (uint16_t i = 0; i < 4000; i++)
            __asm__ volatile("nop");
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

    PORTB = PIN_CS | PIN_RESET;
    DDRB = PIN_CS | PIN_DATA | PIN_RESET | PIN_MOSI | PIN_SCK;
    SPCR = 0x50; /* on, master, mode 0 */
    SPSR = 0x01; /* 8 MHz */
    return etch_lcd_open(&lcd, &etch_st7735_red, &spi, (struct etch_lcd_setup){.turn = 1}) == 0
               ? &lcd.display
               : NULL;
}

void board_print(const char *text)
{
    UCSR0B = 0x08; /* transmitter on, at the speed after reset */
    for (; *text != '\0'; text++) {
        while ((UCSR0A & 0x20) == 0) {
        }
        UDR0 = (uint8_t)*text;
    }
}

/* Sleeps with interrupts off, which ends an emulation. */
void board_exit(int status)
{
    (void)status;
    REGISTER(0x53) = 0x05; /* SMCR: power down */
    __asm__ volatile("cli\n\tsleep");
}
