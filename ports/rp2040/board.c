/* ports/rp2040: Raspberry Pi Pico with an ILI9341 (or what RP2040_PANEL names) on SPI0. Strips go
 * out by DMA while the next one is drawn, by one core or both (hal/workers.h); an interrupt of core
 * 0 tells the end. Wiring: SCK GP18, MOSI GP19, CS GP17, D/C GP20, RESET GP21; text on GP0, 115,200
 * baud. Source: Raspberry Pi, RP2040 data sheet. */
#include "../../hal/guarded.h"
#include "../board.h"
#include "../spi_lcd/panels.h"
#include "rp2040.h"

#ifndef RP2040_PANEL
#define RP2040_PANEL etch_ili9341
#endif
#define GPIO_FUNCTION(pin) REGISTER(0x40014004 + 8 * (uint32_t)(pin))
#define SIO_OUT_SET REGISTER(0xD0000014)
#define SIO_OUT_CLR REGISTER(0xD0000018)
#define SIO_OE_SET REGISTER(0xD0000024)
#define SPI_CR0 REGISTER(0x4003C000)
#define SPI_CR1 REGISTER(0x4003C004)
#define SPI_DR REGISTER(0x4003C008)
#define SPI_SR REGISTER(0x4003C00C)
#define SPI_CPSR REGISTER(0x4003C010)
#define SPI_DMACR REGISTER(0x4003C024)
#define DMA_READ REGISTER(0x50000000)
#define DMA_WRITE REGISTER(0x50000004)
#define DMA_COUNT REGISTER(0x50000008)
#define DMA_CTRL_TRIG REGISTER(0x5000000C)
#define DMA_INTE0 REGISTER(0x50000404)
#define DMA_INTS0 REGISTER(0x5000040C)
#define DMA_ABORT REGISTER(0x50000444)
#define UART_DR REGISTER(0x40034000)
#define UART_FR REGISTER(0x40034018)
#define UART_IBRD REGISTER(0x40034024)
#define UART_FBRD REGISTER(0x40034028)
#define UART_LCR REGISTER(0x4003402C)
#define UART_CR REGISTER(0x40034030)
#define TIMER_US REGISTER(0x40054028)
#define NVIC_ENABLE REGISTER(0xE000E100)
enum {
    PIN_TEXT = 0,
    PIN_CS = 17,
    PIN_SCK = 18,
    PIN_MOSI = 19,
    PIN_DATA = 20, /* D/C */
    PIN_RESET = 21,
    FUNCTION_SPI = 1,
    FUNCTION_UART = 2,
    FUNCTION_SIO = 5,
    SPI_BUSY = 16,
    SPI_RECEIVED = 4,
    SPI_ROOM = 2,
    LIMIT_MS = 500 /* for one piece: a frame takes 40 ms */
};
/* Enabled, bytes, the read address counts, paced by SPI0's transmitter, no other channel after. */
#define DMA_START (UINT32_C(1) | UINT32_C(1) << 4 | UINT32_C(16) << 15)
#define DMA_BUSY (UINT32_C(1) << 24)

static int start_dma(void *context, uint8_t piece, const uint8_t *bytes, uint32_t n);

static struct etch_guarded transfer = {
    .transfer = {.start = start_dma}, .monitor = &rp2040_monitor, .limit_ms = LIMIT_MS};
static uint8_t number; /* of the piece that runs */

/* One piece. In the thread, or in the interrupt of the piece before; inside the monitor. */
static int start_dma(void *context, uint8_t piece, const uint8_t *bytes, uint32_t n)
{
    (void)context;
    number = piece;
    DMA_READ = (uint32_t)(uintptr_t)bytes;
    DMA_WRITE = (uint32_t)(uintptr_t)&SPI_DR;
    DMA_COUNT = n;
    __asm__ volatile("dsb" ::: "memory");
    DMA_CTRL_TRIG = DMA_START;
    return 0;
}

void rp2040_dma_interrupt(void);

void rp2040_dma_interrupt(void)
{
    DMA_INTS0 = 1;
    etch_monitor_enter(&rp2040_monitor);
    if ((DMA_CTRL_TRIG & DMA_BUSY) == 0 && etch_transfer_done(&transfer.transfer, number, 0))
        etch_monitor_signal(&rp2040_monitor);
    etch_monitor_leave(&rp2040_monitor);
}

/* Behind the core's sixteen vectors; of both cores. */
__attribute__((section(".vectors.interrupts"), used)) static void (*const interrupts[32])(void) = {
    [0] = rp2040_alarm_interrupt, [1] = rp2040_alarm_interrupt, [11] = rp2040_dma_interrupt};

static void pin_set(uint8_t pin, bool high)
{
    if (high)
        SIO_OUT_SET = UINT32_C(1) << pin;
    else
        SIO_OUT_CLR = UINT32_C(1) << pin;
}

/* Until the last bit is on the wire; what came in meanwhile is dropped. */
static void drain(void)
{
    while ((SPI_SR & SPI_BUSY) != 0) {
    }
    while ((SPI_SR & SPI_RECEIVED) != 0)
        (void)SPI_DR;
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

static int command(const struct etch_bus *bus, const uint8_t *bytes, uint16_t n)
{
    (void)bus;
    pin_set(PIN_DATA, false);
    while (n-- != 0) {
        while ((SPI_SR & SPI_ROOM) == 0) {
        }
        SPI_DR = *bytes++;
    }
    drain();
    return 0;
}

static int data(const struct etch_bus *bus, struct etch_pieces *pieces)
{
    (void)bus;
    pin_set(PIN_DATA, true);
    return etch_guarded_start(&transfer, pieces);
}

static int wait(const struct etch_bus *bus)
{
    int status = etch_guarded_wait(&transfer);

    (void)bus;
    if (status != 0 || (DMA_CTRL_TRIG & DMA_BUSY) != 0) {
        DMA_ABORT = 1;
        while (DMA_ABORT != 0) {
        }
        status = status != 0 ? status : ETCH_EIO;
    }
    drain();
    return status;
}

static void reset(const struct etch_bus *bus, bool active)
{
    (void)bus;
    pin_set(PIN_RESET, !active);
}

static void delay(const struct etch_bus *bus, uint8_t ms)
{
    const uint32_t start = TIMER_US;

    (void)bus;
    while (TIMER_US - start <= (uint32_t)ms * 1000) {
    }
}

static const struct etch_bus spi = {.begin = begin,
                                    .end = end,
                                    .limit = 0xFFFFFF,
                                    .command = command,
                                    .data = data,
                                    .wait = wait,
                                    .reset = reset,
                                    .delay = delay};

/* Clocks and peripherals, once: what is called first, board_open or board_print, does it. */
static void start(void)
{
    static bool started;
    const uint32_t pins = UINT32_C(1) << PIN_CS | UINT32_C(1) << PIN_DATA |
                          UINT32_C(1) << PIN_RESET;

    if (started)
        return;
    started = true;
    rp2040_clocks_start();
    /* DMA, pins and their pads, SPI0, timer, UART0 */
    rp2040_unreset(UINT32_C(1) << 2 | 1 << 5 | 1 << 8 | UINT32_C(1) << 16 | UINT32_C(1) << 21 |
                   UINT32_C(1) << 22);
    SIO_OUT_SET = pins;
    SIO_OE_SET = pins;
    GPIO_FUNCTION(PIN_CS) = GPIO_FUNCTION(PIN_DATA) = GPIO_FUNCTION(PIN_RESET) = FUNCTION_SIO;
    GPIO_FUNCTION(PIN_SCK) = GPIO_FUNCTION(PIN_MOSI) = FUNCTION_SPI;
    GPIO_FUNCTION(PIN_TEXT) = FUNCTION_UART;
    SPI_CPSR = 2;
    SPI_CR0 = 1 << 8 | 7; /* 125 MHz / 2 / 2 = 31.25 MHz, 8 bits, mode 0 */
    SPI_DMACR = 2;
    SPI_CR1 = 2;
    UART_IBRD = 67; /* 125 MHz / 16 / 115,200 = 67.82 */
    UART_FBRD = 52;
    UART_LCR = 7 << 4; /* 8 bits, FIFO */
    UART_CR = 1 << 8 | 1;
    DMA_INTE0 = 1;
    NVIC_ENABLE = 1 << 11;
}

const struct etch_display *board_open(void)
{
    static struct etch_lcd lcd;

    start();
    return etch_lcd_open(&lcd, &RP2040_PANEL, &spi, (struct etch_lcd_setup){.turn = 1}) == 0
               ? &lcd.display
               : NULL;
}

void board_print(const char *text)
{
    start();
    for (; *text != '\0'; text++) {
        while ((UART_FR & 0x20) != 0) {
        }
        UART_DR = (uint8_t)*text;
    }
}

/* An emulator or a debugger stops here; without one the core faults and idles (start.c). */
void board_exit(int status)
{
    (void)status;
    __asm__ volatile("bkpt 0");
}
