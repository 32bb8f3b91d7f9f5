/* bench/start.c: start-up for the bench firmware on QEMU's mps2 boards (any Cortex-M), and the
 * way out for its pictures by semihosting. */
#include "bench.h"

extern uint32_t link_stack_top, link_bss_start, link_bss_end;

int main(void);
void reset(void);
void *memcpy(void *to, const void *from, size_t n);
void *memset(void *to, int value, size_t n);

static int32_t semihost(int32_t operation, const void *argument)
{
    register int32_t r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;

    __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

enum {
    SYS_OPEN = 1,
    SYS_CLOSE = 2,
    SYS_WRITE = 5,
    SYS_EXIT_EXTENDED = 0x20
};
enum {
    MODE_WRITE_BINARY = 5
};

void bench_write(const char *name, const void *data, uint32_t bytes)
{
    uint32_t length = 0;

    while (name[length] != 0)
        length++;
    const uint32_t open[3] = {(uint32_t)(uintptr_t)name, MODE_WRITE_BINARY, length};
    const int32_t file = semihost(SYS_OPEN, open);
    const uint32_t write[3] = {(uint32_t)file, (uint32_t)(uintptr_t)data, bytes};
    (void)semihost(SYS_WRITE, write);
    const uint32_t close[1] = {(uint32_t)file};
    (void)semihost(SYS_CLOSE, close);
}

void reset(void)
{
    for (uint32_t *p = &link_bss_start; p < &link_bss_end; p++)
        *p = 0;
    const uint32_t stop[2] = {0x20026, (uint32_t)main()}; /* ADP_Stopped_ApplicationExit */
    (void)semihost(SYS_EXIT_EXTENDED, stop);
    for (;;) {
    }
}

__attribute__((section(".vectors"), used)) static const struct {
    uint32_t *stack;
    void (*handler[15])(void);
} vectors = {&link_stack_top, {reset}};

/* What the compiler may call for a struct copy. Plain, so that a copy in a hot place shows. */
void *memcpy(void *to, const void *from, size_t n)
{
    uint8_t *t = to;
    const uint8_t *f = from;

    while (n-- != 0)
        *t++ = *f++;
    return to;
}

void *memset(void *to, int value, size_t n)
{
    uint8_t *t = to;

    while (n-- != 0)
        *t++ = (uint8_t)value;
    return to;
}
