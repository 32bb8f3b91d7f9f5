/* ports/rp2040/cores.c: what two cores need: a lock, waiting, and how the second one starts.
 * board.c and hal/workers.h call it. Source: Raspberry Pi, RP2040 data sheet, 2.3.1 and 2.8.2. */
#include "rp2040.h"

#define SIO_CPUID REGISTER(0xD0000000)
#define FIFO_STATUS REGISTER(0xD0000050)
#define FIFO_WRITE REGISTER(0xD0000054)
#define FIFO_READ REGISTER(0xD0000058)
#define SPINLOCK REGISTER(0xD000017C) /* the last of 32 */
#define TIMER_ALARM(core) REGISTER(0x40054010 + 4 * (core))
#define TIMER_ARMED REGISTER(0x40054020)
#define TIMER_US REGISTER(0x40054028)
#define TIMER_INTR REGISTER(0x40054034)
#define TIMER_INTE REGISTER(0x40054038)
#define NVIC_ENABLE REGISTER(0xE000E100)
#define VECTOR_TABLE REGISTER(0xE000ED08)
enum {
    FIFO_FILLED = 1,
    FIFO_ROOM = 2,
    ANSWER_US = 1000000
};

/* Of whoever is inside. */
static uint32_t saved_mask;

static volatile uint32_t signals; /* how often somebody signalled, modulo 2^32 */

static void enter(const struct etch_monitor *monitor)
{
    uint32_t mask;

    (void)monitor;
    __asm__ volatile("mrs %0, primask\n\tcpsid i" : "=r"(mask)::"memory");
    while (SPINLOCK == 0) {
    }
    __asm__ volatile("dmb" ::: "memory");
    saved_mask = mask;
}

static void leave(const struct etch_monitor *monitor)
{
    const uint32_t mask = saved_mask;

    (void)monitor;
    __asm__ volatile("dmb" ::: "memory");
    SPINLOCK = 0;
    __asm__ volatile("msr primask, %0" ::"r"(mask) : "memory");
}

/* An interrupt of this core, at the latest when the limit is over. */
static void set_alarm(uint32_t core, uint32_t at_us)
{
    TIMER_INTE |= UINT32_C(1) << core;
    NVIC_ENABLE = UINT32_C(1) << core;
    TIMER_ALARM(core) = at_us;
}

void rp2040_alarm_interrupt(void)
{
    TIMER_INTR = UINT32_C(1) << SIO_CPUID;
}

/* A signal between the look at the counter and WFE is not lost: WFE then goes on at once. */
static int wait(const struct etch_monitor *monitor, uint16_t limit_ms)
{
    const uint32_t core = SIO_CPUID, seen = signals, began = TIMER_US;
    const uint32_t limit = (uint32_t)limit_ms * 1000;

    if (limit != 0)
        set_alarm(core, began + limit);
    leave(monitor);
    while (signals == seen && (limit == 0 || TIMER_US - began < limit))
        __asm__ volatile("wfe" ::: "memory");
    enter(monitor);
    TIMER_ARMED = UINT32_C(1) << core;
    return signals != seen ? ETCH_OK : ETCH_EIO;
}

static void signal(const struct etch_monitor *monitor)
{
    (void)monitor;
    signals++;
    __asm__ volatile("dsb\n\tsev" ::: "memory");
}

const struct etch_monitor rp2040_monitor = {
    .enter = enter, .leave = leave, .wait = wait, .signal = signal};

/* ---- core 1 ---------------------------------------------------------------------------------- */

static void (*core1_entry)(void *context);
static void *core1_context;

static void core1_main(void)
{
    core1_entry(core1_context);
    for (;;)
        __asm__ volatile("wfi");
}

/* Tells core 1's boot ROM a word. True if it repeated it. */
static bool tell(uint32_t word, uint32_t began)
{
    if (word == 0) { /* the beginning: drops what is left, and wakes it */
        while ((FIFO_STATUS & FIFO_FILLED) != 0)
            (void)FIFO_READ;
        __asm__ volatile("sev");
    }
    while ((FIFO_STATUS & FIFO_ROOM) == 0) {
    }
    FIFO_WRITE = word;
    __asm__ volatile("sev");
    while ((FIFO_STATUS & FIFO_FILLED) == 0)
        if (TIMER_US - began > ANSWER_US)
            return false;
    return FIFO_READ == word;
}

int rp2040_core1_start(void (*entry)(void *context), void *context, uint32_t *stack_end)
{
    const uint32_t word[6] = {
        0, 0, 1, VECTOR_TABLE, (uint32_t)(uintptr_t)stack_end, (uint32_t)(uintptr_t)core1_main};
    const uint32_t began = TIMER_US;

    core1_entry = entry;
    core1_context = context;
    __asm__ volatile("dmb" ::: "memory");
    for (int i = 0; i < 6;) {
        i = tell(word[i], began) ? i + 1 : 0;
        if (TIMER_US - began > ANSWER_US)
            return ETCH_EIO;
    }
    return ETCH_OK;
}
