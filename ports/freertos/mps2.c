/* ports/freertos/mps2.c: the bus of ports/mps2, whose data go out byte by byte in the serial port's
 * interrupt, as they would by DMA. Called by the panel driver, and by the hardware.
 * Source: Arm, PrimeCell SSP (PL022); Application Note AN385. */
#include "mps2.h"

#include "../../hal/guarded.h"
#include "../board.h"
#include "../spi_lcd/panels.h"

#define REGISTER(address) (*(volatile uint32_t *)(uintptr_t)(address))
#define SSP_DR REGISTER(0x40021008)
#define SSP_SR REGISTER(0x4002100C)
#define SSP_IMSC REGISTER(0x40021014)
#define PINS REGISTER(0x4002804C)
#define NVIC_ENABLE REGISTER(0xE000E100)
#define NVIC_PRIORITY ((volatile uint8_t *)(uintptr_t)0xE000E400)
#define VECTOR_TABLE REGISTER(0xE000ED08)
enum {
    SSP_ROOM = 2, /* in the transmit FIFO */
    SSP_RECEIVED = 4,
    SSP_BUSY = 16,
    SSP_HALF_EMPTY = 8, /* interrupt: the transmit FIFO wants more */
    SSP_INTERRUPT = 11,
    FIFO = 8,
    PIN_DATA = 16, /* D/C */
    CORE_VECTORS = 16,
    VECTORS = 32 + CORE_VECTORS
};

/* The kernel's handlers. */
void vPortSVCHandler(void);
void xPortPendSVHandler(void);
void xPortSysTickHandler(void);
void vApplicationTickHook(void);

volatile uint32_t mps2_transfers;

static struct etch_freertos_monitor monitor;
static struct etch_guarded transfer;
static struct etch_turn turn;

/* The piece that is sent. */
static const uint8_t *at;
static uint32_t left;
static uint8_t number;
static volatile bool sent; /* its last byte */

static int start(void *context, uint8_t piece, const uint8_t *bytes, uint32_t n)
{
    (void)context;
    at = bytes;
    left = n;
    number = piece;
    SSP_IMSC = SSP_HALF_EMPTY;
    return 0;
}

/* A FIFO's worth of bytes. */
static void serial_interrupt(void)
{
    for (int i = 0; i < FIFO && left != 0 && (SSP_SR & SSP_ROOM) != 0; i++, left--)
        SSP_DR = *at++;
    while ((SSP_SR & SSP_RECEIVED) != 0)
        (void)SSP_DR;
    if (left == 0) {
        SSP_IMSC = 0;
        sent = true;
    }
}

/* The kernel's tick, an interrupt too. QEMU's wire takes no time; pieces end with the next
 * millisecond, so that tasks do sleep until then. */
void vApplicationTickHook(void)
{
    if (sent) {
        sent = false;
        mps2_transfers++;
        (void)etch_guarded_done(&transfer, number, 0);
    }
}

static int begin(const struct etch_bus *bus)
{
    const struct etch_bus *board = bus->context;
    const int status = etch_turn_take(&turn, 0);

    return status < 0 ? status : board->begin(board);
}

static void end(const struct etch_bus *bus)
{
    const struct etch_bus *board = bus->context;

    board->end(board);
    etch_turn_give(&turn);
}

static int data(const struct etch_bus *bus, struct etch_pieces *pieces)
{
    (void)bus;
    PINS |= PIN_DATA;
    return etch_guarded_start(&transfer, pieces);
}

static int wait(const struct etch_bus *bus)
{
    const int status = etch_guarded_wait(&transfer);

    (void)bus;
    if (status < 0)
        SSP_IMSC = 0;
    while ((SSP_SR & SSP_BUSY) != 0) {
    }
    return status;
}

/* The kernel's handlers, and this interrupt, behind those that started the board. */
static void set_vectors(void)
{
    static void (*vectors[VECTORS])(void) __attribute__((aligned(256)));
    void (*const *old)(void) = (void (*const *)(void))(uintptr_t)VECTOR_TABLE;

    for (int i = 0; i < CORE_VECTORS; i++)
        vectors[i] = old[i];
    vectors[11] = vPortSVCHandler;
    vectors[14] = xPortPendSVHandler;
    vectors[15] = xPortSysTickHandler;
    vectors[CORE_VECTORS + SSP_INTERRUPT] = serial_interrupt;
    VECTOR_TABLE = (uint32_t)(uintptr_t)vectors;
    NVIC_PRIORITY[SSP_INTERRUPT] = configMAX_SYSCALL_INTERRUPT_PRIORITY;
    NVIC_ENABLE = UINT32_C(1) << SSP_INTERRUPT;
}

/* The board opens its panel with its own bus, which waits for every byte. The same panel is opened
 * again when tasks can sleep: with this bus, whose pins are the board's. */
const struct etch_display *mps2_open(void)
{
    static struct etch_lcd lcd;
    static struct etch_bus bus;
    const struct etch_display *display = board_open();

    if (display == NULL)
        return NULL;
    etch_freertos_monitor_open(&monitor);
    transfer = (struct etch_guarded){
        .transfer = {.start = start}, .monitor = &monitor.monitor, .limit_ms = 1000};
    turn.monitor = &monitor.monitor;
    bus = *((const struct etch_lcd *)display->context)->bus;
    bus.context = (void *)((const struct etch_lcd *)display->context)->bus;
    lcd = *(const struct etch_lcd *)display->context;
    lcd.bus = &bus;
    lcd.display.context = &lcd;
    bus.begin = begin;
    bus.end = end;
    bus.data = data;
    bus.wait = wait;
    set_vectors();
    return &lcd.display;
}

void mps2_stop(void)
{
    board_print("assertion of the kernel\n");
    board_exit(1);
}
