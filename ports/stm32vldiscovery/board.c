/* ports/stm32vldiscovery: ST's STM32VLDISCOVERY (STM32F100RB, Cortex-M3, 8 KB of RAM) on its
 * internal 8 MHz clock with an ILI9341 on SPI1. Wiring: SCK PA5, MOSI PA7, CS PB0, D/C PB1, RESET
 * PB5. Source: ST, reference manual RM0041. */
#include "../board.h"
#include "../cortex_m/systick.h"
#include "../spi_lcd/panels.h"

#define REGISTER(address) (*(volatile uint32_t *)(uintptr_t)(address))
#define RCC_APB2ENR REGISTER(0x40021018)
#define GPIOA_CRL REGISTER(0x40010800)
#define GPIOB_CRL REGISTER(0x40010C00)
#define GPIOB_BSRR REGISTER(0x40010C10)
#define SPI1_CR1 REGISTER(0x40013000)
#define SPI1_SR REGISTER(0x40013008)
#define SPI1_DR REGISTER(0x4001300C)
enum {
    CLOCK = 8000000,
    MASTER = 1 << 2,
    ENABLE = 1 << 6,
    SOFT_SELECT = 3 << 8, /* SSM and SSI */
    EMPTY = 1 << 1,       /* of SR: the transmit buffer */
    BUSY = 1 << 7
};
enum { /* of port B */
    PIN_CS = 1 << 0,
    PIN_DATA = 1 << 1, /* D/C */
    PIN_RESET = 1 << 5
};

static void pin_set(uint32_t pin, bool high)
{
    GPIOB_BSRR = high ? pin : pin << 16;
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

/* Returns when the last bit is on the wire. What comes in is dropped: nothing reads it. */
static void send(const uint8_t *bytes, uint32_t n)
{
    while (n-- != 0) {
        while ((SPI1_SR & EMPTY) == 0) {
        }
        SPI1_DR = *bytes++;
    }
    while ((SPI1_SR & EMPTY) == 0 || (SPI1_SR & BUSY) != 0) {
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
    systick_delay(CLOCK, ms);
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

    RCC_APB2ENR |= 1 << 12 | 1 << 3 | 1 << 2; /* SPI1, ports B and A */
    GPIOB_BSRR = PIN_CS | PIN_RESET;
    GPIOB_CRL = (GPIOB_CRL & ~UINT32_C(0xF000FF)) | 0x300033;     /* pins 0, 1, 5: output */
    GPIOA_CRL = (GPIOA_CRL & ~UINT32_C(0xF0F00000)) | 0xB0B00000; /* pins 5, 7: SPI1 */
    SPI1_CR1 = MASTER | SOFT_SELECT | ENABLE;                     /* 4 MHz, mode 0 */
    return etch_lcd_open(&lcd, &etch_ili9341, &spi, (struct etch_lcd_setup){.turn = 1}) == 0
               ? &lcd.display
               : NULL;
}
