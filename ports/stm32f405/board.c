/* ports/stm32f405: an STM32F405 on its internal 16 MHz clock (Netduino Plus 2, Olimex H405) with an
 * ILI9341 on SPI1. Wiring: SCK PA5, MOSI PA7, CS PB0, D/C PB1, RESET PB2.
 * Source: ST, reference manual RM0090. */
#include "../board.h"
#include "../cortex_m/systick.h"
#include "../spi_lcd/panels.h"

#define REGISTER(address) (*(volatile uint32_t *)(uintptr_t)(address))
#define RCC_AHB1ENR REGISTER(0x40023830)
#define RCC_APB2ENR REGISTER(0x40023844)
#define GPIOA_MODER REGISTER(0x40020000)
#define GPIOA_AFRL REGISTER(0x40020020)
#define GPIOB_MODER REGISTER(0x40020400)
#define GPIOB_BSRR REGISTER(0x40020418)
#define SPI1_CR1 REGISTER(0x40013000)
#define SPI1_SR REGISTER(0x40013008)
#define SPI1_DR REGISTER(0x4001300C)
enum {
    CLOCK = 16000000,
    MASTER = 1 << 2,
    ENABLE = 1 << 6,
    SOFT_SELECT = 3 << 8, /* SSM and SSI */
    EMPTY = 1 << 1,       /* of SR: the transmit buffer */
    BUSY = 1 << 7
};
enum { /* of port B */
    PIN_CS = 1 << 0,
    PIN_DATA = 1 << 1, /* D/C */
    PIN_RESET = 1 << 2
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

    RCC_AHB1ENR |= 3;                 /* ports A and B */
    RCC_APB2ENR |= UINT32_C(1) << 12; /* SPI1 */
    GPIOB_BSRR = PIN_CS | PIN_RESET;
    GPIOB_MODER = (GPIOB_MODER & ~UINT32_C(0x3F)) | 0x15; /* pins 0, 1, 2: output */
    GPIOA_AFRL = (GPIOA_AFRL & ~UINT32_C(0xF0F00000)) | 0x50500000;
    GPIOA_MODER = (GPIOA_MODER & ~UINT32_C(0xCC00)) | 0x8800; /* pins 5, 7: SPI1 */
    SPI1_CR1 = MASTER | SOFT_SELECT | ENABLE;                 /* 8 MHz, mode 0 */
    return etch_lcd_open(&lcd, &etch_ili9341, &spi, (struct etch_lcd_setup){.turn = 1}) == 0
               ? &lcd.display
               : NULL;
}
