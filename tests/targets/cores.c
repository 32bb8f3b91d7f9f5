/* tests/targets: the program of `make run-rp2040-cores`: a torus drawn by CORES cores, 1 or 2,
 * through hal/workers.h. */
#include "hal/workers.h"
#include "ports/board.h"
#include "ports/rp2040/rp2040.h"
#include "tests/workers/torus.h"

int main(void);

enum {
    ROWS = 16,
    STRIP = 320 * ROWS,
    STACK = 1024, /* words */
    PIN_DRAWS = 22
};

#define GPIO_FUNCTION(pin) REGISTER(0x40014004 + 8 * (uint32_t)(pin))
#define SIO_OUT_SET REGISTER(0xD0000014)
#define SIO_OUT_CLR REGISTER(0xD0000018)
#define SIO_OE_SET REGISTER(0xD0000024)

static struct torus torus;
static struct etch_workers workers;
static struct {
    struct etch_worker worker;
    uint16_t pixels[2][STRIP], depth[STRIP];
} hand[CORES];
static uint32_t stack[STACK] __attribute__((aligned(8)));
static volatile bool helped; /* core 1 was there */

/* The pin is high while the frame is drawn: instructions are counted then. */
static void open_pin(void)
{
    SIO_OUT_CLR = UINT32_C(1) << PIN_DRAWS;
    SIO_OE_SET = UINT32_C(1) << PIN_DRAWS;
    GPIO_FUNCTION(PIN_DRAWS) = 5;
}

/* Core 1. */
static void help(void *context)
{
    struct etch_worker *worker = context;

    while (etch_worker_begin(worker)) {
        helped = true;
        torus_draw_share(&torus, worker);
    }
    for (;;)
        __asm__ volatile("wfi");
}

static int open_workers(const struct etch_display *display)
{
    int status = etch_workers_init(&workers, display, &rp2040_monitor, ROWS);

    for (int i = 0; i < CORES && status == 0; i++) {
        const struct etch_frame_memory memory = {.pixels = {hand[i].pixels[0], hand[i].pixels[1]},
                                                 .depth = hand[i].depth,
                                                 .size = STRIP};

        status = etch_worker_init(&hand[i].worker, &workers, memory);
    }
    if (CORES > 1 && status == 0)
        status = rp2040_core1_start(help, &hand[CORES - 1].worker, stack + STACK);
    return status;
}

static int draw(const struct etch_display *display)
{
    int status;

    torus.swapped = display->format == ETCH_FORMAT_RGB565_SWAPPED;
    torus_make(&torus);
    torus_turn(&torus, 0, display->width, display->height);
    open_pin();
    status = open_workers(display);
    if (status != 0)
        return status;
    SIO_OUT_SET = UINT32_C(1) << PIN_DRAWS;
    etch_workers_begin(&workers);
    (void)etch_worker_begin(&hand[0].worker);
    torus_draw_share(&torus, &hand[0].worker);
    status = etch_workers_end(&workers);
    SIO_OUT_CLR = UINT32_C(1) << PIN_DRAWS;
    return status == 0 && CORES > 1 && !helped ? ETCH_EIO : status;
}

int main(void)
{
    const struct etch_display *display = board_open();
    const int status = display == NULL ? ETCH_EIO : draw(display);

    board_print(status == 0 ? "drawn\n" : "FAIL\n");
    return status == 0 ? 0 : 1;
}
