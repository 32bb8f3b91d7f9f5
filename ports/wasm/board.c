/* ports/wasm: WebAssembly as a board: the display is memory that the page or node reads after main.
 * The module imports one function, env.print(address of text). */
#include "../board.h"
#include "../framebuffer/framebuffer.h"

enum {
    WIDTH = 320,
    HEIGHT = 240
};

static uint16_t memory[WIDTH * HEIGHT];

__attribute__((import_module("env"), import_name("print"))) void wasm_print(const char *text);
__attribute__((export_name("start"))) int wasm_start(void);
__attribute__((export_name("pixels"))) const uint16_t *wasm_pixels(void);

int main(void);

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

    return &display;
}

int wasm_start(void)
{
    return main();
}

/* The frame, WIDTH x HEIGHT, RGB565, little-endian. */
const uint16_t *wasm_pixels(void)
{
    return memory;
}

void board_print(const char *text)
{
    wasm_print(text);
}

void board_exit(int status)
{
    (void)status; /* start returns it */
}
