/* ports/linux_bare: a Linux process without a C library as a board: the display is memory, which
 * board_exit writes to standard output as big-endian RGB565. For processors whose libraries are not
 * at hand, under QEMU's user mode: it is how big-endian machines are tested.
 * Source: Linux, the system call interfaces of MIPS64 and AArch64. */
#include "../board.h"
#include "../framebuffer/framebuffer.h"

enum {
    WIDTH = 320,
    HEIGHT = 240,
    OUTPUT = 1,
    ERRORS = 2
};

static uint16_t memory[WIDTH * HEIGHT];
static bool opened;

int main(void);
void start(void);

#if defined(__mips64)
enum {
    SYS_WRITE = 5001,
    SYS_EXIT = 5058
};

static long call(long number, long a, long b, long c)
{
    register long v0 __asm__("$2") = number;
    register long a0 __asm__("$4") = a;
    register long a1 __asm__("$5") = b;
    register long a2 __asm__("$6") = c;
    register long a3 __asm__("$7");

    __asm__ volatile("syscall"
                     : "+r"(v0), "=r"(a3)
                     : "r"(a0), "r"(a1), "r"(a2)
                     : "memory", "$1", "$3", "$10", "$11", "$12", "$13", "$14", "$15", "$24",
                       "$25");
    return v0;
}
#elif defined(__aarch64__)
enum {
    SYS_WRITE = 64,
    SYS_EXIT = 93
};

static long call(long number, long a, long b, long c)
{
    register long x8 __asm__("x8") = number;
    register long x0 __asm__("x0") = a;
    register long x1 __asm__("x1") = b;
    register long x2 __asm__("x2") = c;

    __asm__ volatile("svc 0" : "+r"(x0) : "r"(x8), "r"(x1), "r"(x2) : "memory");
    return x0;
}
#endif

static void write_all(int file, const uint8_t *data, long n)
{
    while (n > 0) {
        const long done = call(SYS_WRITE, file, (long)(uintptr_t)data, n);

        if (done <= 0)
            (void)call(SYS_EXIT, 1, 0, 0);
        data += done;
        n -= done;
    }
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

    opened = true;
    return &display;
}

void board_print(const char *text)
{
    long n = 0;

    while (text[n] != '\0')
        n++;
    write_all(ERRORS, (const uint8_t *)text, n);
}

void board_exit(int status)
{
    for (int i = 0; opened && i < WIDTH * HEIGHT; i++) {
        static uint8_t bytes[2 * WIDTH];
        const int column = i % WIDTH;

        bytes[2 * column] = (uint8_t)(memory[i] >> 8);
        bytes[2 * column + 1] = (uint8_t)memory[i];
        if (column == WIDTH - 1)
            write_all(OUTPUT, bytes, sizeof bytes);
    }
    (void)call(SYS_EXIT, status, 0, 0);
}

void start(void)
{
    board_exit(main());
}
