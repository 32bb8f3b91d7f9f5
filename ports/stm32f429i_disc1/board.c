/* ports/stm32f429i_disc1: ST's 32F429IDISCOVERY. Its ILI9341 is driven twice: SPI5 sets it up once,
 * then the LTDC sends it RGB565 from internal RAM, 60 times a second. 192 KB hold a frame of 150
 * KB, so that the external memory stays free. Only built: no emulator here has these peripherals.
 * Source: ST, reference manual RM0090, user manual UM1670; Ilitek, ILI9341 data sheet. */
#include "../board.h"
#include "../cortex_m/systick.h"
#include "../framebuffer/framebuffer.h"
#include "f429.h"

enum {
    CLOCK = 168000000,
    WIDTH = 240,
    HEIGHT = 320,
    LIMIT = 100000 /* turns of a loop that waits for a clock */
};

/* One frame. The LTDC reads it all the time. */
static uint16_t memory[WIDTH * HEIGHT] __attribute__((aligned(64)));

/* ---- clocks ------------------------------------------------------------------------------------
 */

static bool waited(volatile uint32_t *at, uint32_t mask, uint32_t value)
{
    for (uint32_t turns = LIMIT; turns != 0; turns--)
        if ((*at & mask) == value)
            return true;
    return false;
}

/* 8 MHz of the crystal / 8 * 336 / 2 = 168 MHz; buses at a quarter and a half of it; pixels at
 * 1 MHz * 192 / 4 / 8 = 6 MHz. */
static bool start_clocks(void)
{
    RCC_CR |= RCC_CRYSTAL;
    if (!waited(&RCC_CR, RCC_CRYSTAL << 1, RCC_CRYSTAL << 1))
        return false;
    FLASH_ACR = 5 | 7 << 8; /* wait states for 168 MHz; prefetch and both caches */
    RCC_PLLCFGR = 8 | 336 << 6 | UINT32_C(1) << 22 | UINT32_C(7) << 24;
    RCC_PLLSAICFGR = 192 << 6 | UINT32_C(7) << 24 | UINT32_C(4) << 28;
    RCC_DCKCFGR = (RCC_DCKCFGR & ~(UINT32_C(3) << 16)) | UINT32_C(2) << 16; /* / 8 */
    RCC_CR |= RCC_PLL | RCC_PLLSAI;
    if (!waited(&RCC_CR, (RCC_PLL | RCC_PLLSAI) << 1, (RCC_PLL | RCC_PLLSAI) << 1))
        return false;
    RCC_CFGR = 2 | 5 << 10 | 4 << 13;
    return waited(&RCC_CFGR, 3 << 2, 2 << 2);
}

/* ---- pins --------------------------------------------------------------------------------------
 */

enum port {
    A,
    B,
    C,
    D,
    E,
    F,
    G
};

static void make_function(enum port port, uint8_t pin, uint8_t function)
{
    volatile uint32_t *const gpio = &GPIO(port);

    gpio[GPIO_AFR + (pin >> 3)] |= (uint32_t)function << 4 * (pin & 7);
    gpio[GPIO_SPEED] |= UINT32_C(2) << 2 * pin;
    gpio[GPIO_MODE] |= UINT32_C(2) << 2 * pin;
}

static void pin_set(enum port port, uint8_t pin, bool high)
{
    (&GPIO(port))[GPIO_SET] = UINT32_C(1) << (high ? pin : pin + 16);
}

static void make_output(enum port port, uint8_t pin)
{
    pin_set(port, pin, true);
    (&GPIO(port))[GPIO_MODE] |= UINT32_C(1) << 2 * pin;
}

/* The panel's lines as UM1670 lists them: two numbers a pin, port and pin. */
static void start_pins(void)
{
    static const uint8_t display[] = {A, 3, A, 4, A, 6,  A, 11, A, 12, B, 8,  B, 9, B, 10, B, 11,
                                      C, 6, C, 7, C, 10, D, 3,  D, 6,  F, 10, G, 6, G, 7,  G, 11};
    static const uint8_t crossed[] = {B, 0, B, 1, G, 10, G, 12}; /* red 3 and 6, green 3, blue 4 */

    RCC_AHB1ENR |= 0x7F; /* ports A to G */
    for (uint8_t i = 0; i < sizeof display; i += 2)
        make_function((enum port)display[i], display[i + 1], 14);
    for (uint8_t i = 0; i < sizeof crossed; i += 2)
        make_function((enum port)crossed[i], crossed[i + 1], 9);
    make_function(F, 7, 5); /* SPI5: clock and data */
    make_function(F, 9, 5);
    make_output(C, 2);  /* CS */
    make_output(D, 13); /* D/C */
}

/* ---- the panel, once, by SPI5 ------------------------------------------------------------------
 */

static void send(uint8_t byte)
{
    while ((SPI5_SR & SPI_EMPTY) == 0) {
    }
    SPI5_DR = byte;
    while ((SPI5_SR & SPI_EMPTY) == 0 || (SPI5_SR & SPI_BUSY) != 0) {
    }
}

static void command(uint8_t code, const uint8_t *parameters, uint8_t n)
{
    pin_set(C, 2, false);
    pin_set(D, 13, false);
    send(code);
    pin_set(D, 13, true);
    while (n-- != 0)
        send(*parameters++);
    pin_set(C, 2, true);
}

/* Count of parameters, command, parameters. Supplies as in ports/spi_lcd/ili9341.c; then pixels
 * from the RGB lines (B0, B6, F6) instead of from the panel's own memory. */
static const uint8_t panel_table[] = {
    3, 0xCF, 0x00, 0xC1, 0x30,             /* power control B */
    4, 0xED, 0x64, 0x03, 0x12, 0x81,       /* order of supplies */
    3, 0xE8, 0x85, 0x00, 0x78,             /* driver timing A */
    5, 0xCB, 0x39, 0x2C, 0x00, 0x34, 0x02, /* power control A */
    1, 0xF7, 0x20,                         /* pump */
    2, 0xEA, 0x00, 0x00,                   /* driver timing B */
    2, 0xB1, 0x00, 0x1B,                   /* 70 frames a second of its own clock */
    1, 0xC0, 0x10, 1,    0xC1, 0x10,       /* GVDD, step-up factors */
    2, 0xC5, 0x45, 0x15, 1,    0xC7, 0x90, /* VCOM */
    1, 0x36, 0xC8,                         /* upright, blue first on the glass */
    1, 0xB0, 0xC2,                         /* lines: DE, its edge, clock's edge */
    4, 0xB6, 0x0A, 0xA7, 0x27, 0x04,       /* rows by the lines' clock */
    3, 0xF6, 0x01, 0x00, 0x06,             /* pixels by the RGB lines, 18 bits, none kept */
    0};

static void start_panel(void)
{
    const uint8_t *row = panel_table;

    RCC_APB2ENR |= UINT32_C(1) << 20;                              /* SPI5 */
    SPI5_CR1 = SPI_MASTER | 3 << 3 | SPI_SOFT_SELECT | SPI_ENABLE; /* 84 MHz / 16 */
    command(0x01, NULL, 0);
    systick_delay(CLOCK, 120);
    for (; *row != 0; row += *row + 2)
        command(row[1], row + 2, row[0]);
    command(0x11, NULL, 0); /* wake up */
    systick_delay(CLOCK, 120);
    command(0x29, NULL, 0); /* display on */
}

/* ---- the LTDC ----------------------------------------------------------------------------------
 */

/* Clocks of a line: 10 of sync, 20 behind it, 240 of pixels, 10 before the next; rows: 2, 2,
 * 320, 4. The registers take sums less one. 280 * 328 clocks of 6 MHz are 65 frames a second. */
static void start_ltdc(void)
{
    enum {
        LEFT = 10 + 20,
        TOP = 2 + 2
    };

    RCC_APB2ENR |= UINT32_C(1) << 26;
    LTDC_SYNC = UINT32_C(9) << 16 | 1;
    LTDC_BACK = (uint32_t)(LEFT - 1) << 16 | (TOP - 1);
    LTDC_ACTIVE = (uint32_t)(LEFT + WIDTH - 1) << 16 | (TOP + HEIGHT - 1);
    LTDC_TOTAL = (uint32_t)(LEFT + WIDTH + 10 - 1) << 16 | (TOP + HEIGHT + 4 - 1);
    LAYER_COLUMNS = (uint32_t)(LEFT + WIDTH - 1) << 16 | LEFT;
    LAYER_ROWS = (uint32_t)(TOP + HEIGHT - 1) << 16 | TOP;
    LAYER_FORMAT = 2; /* RGB565 */
    LAYER_ALPHA = 255;
    LAYER_BLEND = 4 << 8 | 5; /* by the constant alpha: opaque */
    LAYER_MEMORY = (uint32_t)(uintptr_t)memory;
    LAYER_STRIDE = (uint32_t)(WIDTH * 2) << 16 | (WIDTH * 2 + 3);
    LAYER_LINES = HEIGHT;
    LAYER_CONTROL = 1;
    LTDC_RELOAD = 1;
    LTDC_CONTROL |= 1;
}

const struct etch_display *board_open(void)
{
    static struct etch_framebuffer linear = {memory, WIDTH};
    static const struct etch_display display = {.context = &linear,
                                                .width = WIDTH,
                                                .height = HEIGHT,
                                                .format = ETCH_FORMAT_RGB565,
                                                .flush = etch_framebuffer_flush,
                                                .wait = etch_framebuffer_wait,
                                                .memory = etch_framebuffer_memory};

    if (!start_clocks())
        return NULL;
    start_pins();
    start_panel();
    start_ltdc();
    return &display;
}
