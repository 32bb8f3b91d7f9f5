/* ports/pl11x: boards of Arm's with a PL110 or PL111 display controller, which reads RGB565 from
 * linear memory: Versatile PB (ARM926) and Versatile Express (Cortex-A15). The addresses come from
 * board.mk. Source: Arm, PrimeCell Color LCD Controller, technical reference manuals. */
#include "../board.h"
#include "../framebuffer/framebuffer.h"

#define REGISTER(address) (*(volatile uint32_t *)(uintptr_t)(address))
#define TIMING0 REGISTER(PL11X_BASE + 0x00)
#define TIMING1 REGISTER(PL11X_BASE + 0x04)
#define UPPER_BASE REGISTER(PL11X_BASE + 0x10)
#define CONTROL REGISTER(PL11X_BASE + PL11X_CONTROL)
enum {
    WIDTH = 320,
    HEIGHT = 240,
    ON = 1 << 0 | 1 << 11, /* enabled, powered */
    TFT = 1 << 5,
    BGR = 1 << 8 /* the boards wire red to the low bits */
};

static uint16_t memory[WIDTH * HEIGHT] __attribute__((aligned(16)));

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

#ifdef PL11X_MUX
    REGISTER(PL11X_MUX) = 2; /* the board's multiplexer: 16 bits, 5:6:5 */
#endif
    TIMING0 = (WIDTH / 16 - 1) << 2;
    TIMING1 = HEIGHT - 1;
    UPPER_BASE = (uint32_t)(uintptr_t)memory;
    CONTROL = ON | TFT | PL11X_FORMAT << 1 | BGR;
    return &display;
}

void board_print(const char *text)
{
    register uint32_t r0 __asm__("r0") = 4; /* semihosting, SYS_WRITE0 */
    register const void *r1 __asm__("r1") = text;

    __asm__ volatile("svc 0x123456" : "+r"(r0) : "r"(r1) : "memory", "lr");
}

void board_exit(int status)
{
    (void)status; /* goes on to show the screen */
    for (;;) {
    }
}
