/* ports/lm3s6965evb: Stellaris LM3S6965 evaluation board (Cortex-M3) with the SSD0323 OLED that is
 * soldered to it, 128 x 64 in 16 greys, on SSI0. The card reader shares the bus.
 * Source: Texas Instruments, LM3S6965 data sheet and evaluation board user's manual. */
#include "../board.h"
#include "../cortex_m/systick.h"
#include "../spi_lcd/panels.h"

#define REGISTER(address) (*(volatile uint32_t *)(uintptr_t)(address))
#define RCGC1 REGISTER(0x400FE104)
#define RCGC2 REGISTER(0x400FE108)
#define SSI_CR0 REGISTER(0x40008000)
#define SSI_CR1 REGISTER(0x40008004)
#define SSI_DR REGISTER(0x40008008)
#define SSI_SR REGISTER(0x4000800C)
#define SSI_CPSR REGISTER(0x40008010)
enum {
    CLOCK = 12000000, /* main oscillator divided as after reset */
    SSI_8_BITS = 7,
    SSI_ENABLE = 2,
    SSI_ROOM = 2,
    SSI_RECEIVED = 4,
    SSI_BUSY = 16
};

/* GPIO: data register masked by the address, direction, alternate function, digital enable. */
#define GPIO_PIN(port, pin) REGISTER((port) + ((UINT32_C(1) << (pin)) << 2))
#define GPIO_DIR(port) REGISTER((port) + 0x400)
#define GPIO_AFSEL(port) REGISTER((port) + 0x420)
#define GPIO_DEN(port) REGISTER((port) + 0x51C)
#define PORT_A UINT32_C(0x40004000)
#define PORT_C UINT32_C(0x40006000)
#define PORT_D UINT32_C(0x40007000)
#define PIN_OLED_CS GPIO_PIN(PORT_A, 3)
#define PIN_DATA GPIO_PIN(PORT_C, 7) /* D/C */
#define PIN_CARD_CS GPIO_PIN(PORT_D, 0)

static int begin(const struct etch_bus *bus)
{
    (void)bus;
    PIN_OLED_CS = 0;
    return 0;
}

static void end(const struct etch_bus *bus)
{
    (void)bus;
    PIN_OLED_CS = 1 << 3;
}

/* Returns when the last bit is on the wire. What comes in meanwhile is taken out. */
static void send(const uint8_t *bytes, uint32_t n)
{
    while (n-- != 0) {
        while ((SSI_SR & SSI_ROOM) == 0) {
        }
        SSI_DR = *bytes++;
        while ((SSI_SR & SSI_RECEIVED) == 0) {
        }
        (void)SSI_DR;
    }
    while ((SSI_SR & SSI_BUSY) != 0) {
    }
}

static int command(const struct etch_bus *bus, const uint8_t *bytes, uint16_t n)
{
    (void)bus;
    PIN_DATA = 0;
    send(bytes, n);
    return 0;
}

static int data(const struct etch_bus *bus, struct etch_pieces *pieces)
{
    const uint8_t *bytes;
    uint32_t n;

    (void)bus;
    PIN_DATA = 1 << 7;
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

/* The panel's reset is the board's. */
static void reset(const struct etch_bus *bus, bool active)
{
    (void)bus;
    (void)active;
}

static void delay(const struct etch_bus *bus, uint8_t ms)
{
    (void)bus;
    systick_delay(CLOCK, ms);
}

static const struct etch_bus ssi = {.begin = begin,
                                    .end = end,
                                    .command = command,
                                    .data = data,
                                    .wait = wait,
                                    .reset = reset,
                                    .delay = delay};

const struct etch_display *board_open(void)
{
    static struct etch_lcd lcd;
    static uint8_t scratch[128];
    const struct etch_lcd_setup setup = {.scratch = scratch, .scratch_size = sizeof scratch};

    RCGC1 |= 1 << 4;              /* SSI0 */
    RCGC2 |= 1 | 1 << 2 | 1 << 3; /* ports A, C, D */
    GPIO_AFSEL(PORT_A) |= 1 << 2 | 1 << 5;
    GPIO_DIR(PORT_A) |= 1 << 3;
    GPIO_DEN(PORT_A) |= 1 << 2 | 1 << 3 | 1 << 5;
    GPIO_DIR(PORT_C) |= 1 << 7;
    GPIO_DEN(PORT_C) |= 1 << 7;
    GPIO_DIR(PORT_D) |= 1;
    GPIO_DEN(PORT_D) |= 1;
    PIN_CARD_CS = 1;
    SSI_CR1 = 0;
    SSI_CR0 = SSI_8_BITS;
    SSI_CPSR = 2;
    SSI_CR1 = SSI_ENABLE;
    return etch_lcd_open(&lcd, &etch_ssd0323, &ssi, setup) == 0 ? &lcd.display : NULL;
}
