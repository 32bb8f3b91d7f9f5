/* tests/harness: what the instrumented core calls before each load and store, and in each block.
 * See stores.h. */
#include "stores.h"

#include "canvas.h"

static struct test_canvas *watched;

void test_stores_watch(struct test_canvas *c)
{
    size_t i;

    watched = c;
    c->strayed = false;
    for (i = 0; TEST_STORES && i < TEST_CANVAS_WORDS; i++)
        c->stores[i] = 0;
}

/* Counts one 16-bit element of the colour plane. */
static void count(struct test_canvas *c, size_t element)
{
    const struct etch_surface *s = &c->surface;
    const int32_t y = (int32_t)(element / s->stride) + s->window.y0;
    const int32_t x = (int32_t)(element % s->stride) + s->window.x0;

    if (x < s->clip.x0 || x >= s->clip.x1 || y < s->clip.y0 || y >= s->clip.y1)
        c->strayed = true;
    else if (c->stores[element] < UINT8_MAX)
        c->stores[element]++;
}

/* Bytes [at, at + size) are written. */
static void stored(const void *address, size_t size)
{
    const uintptr_t at = (uintptr_t)address;
    uintptr_t plane, byte;

    if (watched == NULL)
        return;
    plane = (uintptr_t)watched->pixels;
    for (byte = at; byte < at + size; byte += 2) {
        if (byte < plane || byte >= plane + sizeof watched->pixels)
            continue;
        if (byte < plane + 2 * TEST_GUARD_WORDS ||
            byte >= plane + 2 * (TEST_GUARD_WORDS + TEST_CANVAS_WORDS))
            watched->strayed = true;
        else
            count(watched, (byte - plane) / 2 - TEST_GUARD_WORDS);
    }
}

/* The names that gcc and clang call. */
#define HOOK(name)                                                                                 \
    void name(void *address);                                                                      \
    void name(void *address)
#define HOOKS(size)                                                                                \
    HOOK(__tsan_write##size)                                                                       \
    {                                                                                              \
        stored(address, size);                                                                     \
    }                                                                                              \
    HOOK(__tsan_unaligned_write##size)                                                             \
    {                                                                                              \
        stored(address, size);                                                                     \
    }                                                                                              \
    HOOK(__tsan_read##size)                                                                        \
    {                                                                                              \
        (void)address;                                                                             \
    }                                                                                              \
    HOOK(__tsan_unaligned_read##size)                                                              \
    {                                                                                              \
        (void)address;                                                                             \
    }
HOOKS(1)
HOOKS(2)
HOOKS(4)
HOOKS(8)
HOOKS(16)

HOOK(__tsan_func_entry)
{
    (void)address;
}

void __tsan_init(void);
void __tsan_init(void)
{
}

void __tsan_func_exit(void);
void __tsan_func_exit(void)
{
}

void __tsan_read_range(const void *address, size_t size);
void __tsan_read_range(const void *address, size_t size)
{
    (void)address;
    (void)size;
}

void __tsan_write_range(void *address, size_t size);
void __tsan_write_range(void *address, size_t size)
{
    stored(address, size);
}

void *__tsan_memset(void *to, int value, size_t size);
void *__tsan_memset(void *to, int value, size_t size)
{
    uint8_t *p = to;

    stored(to, size);
    for (; size != 0; size--)
        *p++ = (uint8_t)(value & 255);
    return to;
}

void *__tsan_memcpy(void *to, const void *from, size_t size);
void *__tsan_memcpy(void *to, const void *from, size_t size)
{
    const uint8_t *f = from;
    uint8_t *p = to;

    stored(to, size);
    for (; size != 0; size--)
        *p++ = *f++;
    return to;
}

static uint32_t blocks;

void __sanitizer_cov_trace_pc(void);
void __sanitizer_cov_trace_pc(void)
{
    if (blocks < UINT32_MAX)
        blocks++;
}

uint32_t test_blocks(void)
{
    const uint32_t n = blocks;

    blocks = 0;
    return n;
}
