/* ports/freertos/main.c: the program of `make run-freertos`: SCENE on the panel,
 * drawn by one task while interrupts send what it has drawn (WORKERS 1), or by two (WORKERS 2). A
 * task of higher priority wakes every millisecond and draws into memory of its own meanwhile. */
#include "../../hal/workers.h"
#include "../../core/draw/shapes.h"
#include "../../tests/targets/scenes.h"
#include "../board.h"
#include "mps2.h"

int main(void);

enum {
    STRIP = 5120,
    STACK = 2048, /* words */
    SIDE = 32
};

static const struct etch_display *display;
static struct etch_freertos_monitor monitor;
static struct etch_workers workers;
static struct {
    struct etch_worker worker;
    uint16_t pixels[2][STRIP], depth[STRIP];
    uint32_t strips;
    StaticTask_t task;
    StackType_t stack[STACK];
} hand[WORKERS];
static struct {
    uint16_t pixels[SIDE * SIDE];
    StaticTask_t task;
    StackType_t stack[STACK];
    volatile uint32_t frames;
    volatile bool wrong;
} other;

static void finish(const char *text, int status)
{
    board_print(text);
    board_exit(status);
}

/* ---- the other task and its surface ---------------------------------------------------------- */

/* A bar that moves: 4 columns of 32 rows, whatever the other tasks do meanwhile. */
static void draw_bar(void *context)
{
    const struct etch_rect window = {0, 0, SIDE, SIDE};
    struct etch_surface s;

    (void)context;
    (void)etch_surface_init(&s, other.pixels, window, SIDE);
    for (;; other.frames++) {
        const int16_t x = (int16_t)(other.frames % (SIDE - 4));
        int lit = 0;

        etch_surface_clear(&s, 1);
        etch_rect_fill(&s, x, 0, 4, SIDE, 2);
        for (int i = 0; i < SIDE * SIDE; i++)
            lit += other.pixels[i] == 2 && i % SIDE >= x && i % SIDE < x + 4;
        other.wrong |= lit != 4 * SIDE;
        vTaskDelay(1);
    }
}

/* ---- the frame ------------------------------------------------------------------------------- */

static void draw_strips(int i)
{
    const bool swapped = display->format == ETCH_FORMAT_RGB565_SWAPPED;

    for (const struct etch_surface *s; (s = etch_worker_next(&hand[i].worker)) != NULL;) {
        SCENE.draw(s, swapped);
        hand[i].strips++;
    }
}

static void help(void *context)
{
    (void)context;
    while (etch_worker_begin(&hand[WORKERS - 1].worker))
        draw_strips(WORKERS - 1);
    for (;;)
        vTaskDelay(portMAX_DELAY);
}

static int draw_by_workers(void)
{
    etch_workers_begin(&workers);
    (void)etch_worker_begin(&hand[0].worker);
    draw_strips(0);
    return etch_workers_end(&workers);
}

static int draw_by_one(void)
{
    const struct etch_frame_memory memory = hand[0].worker.memory;
    struct etch_frame frame;
    const int status = etch_frame_init(&frame, display, memory);

    if (status != 0)
        return status;
    for (struct etch_surface *s = etch_frame_begin(&frame); s != NULL; s = etch_frame_next(&frame))
        SCENE.draw(s, display->format == ETCH_FORMAT_RGB565_SWAPPED);
    return etch_frame_end(&frame);
}

static void render(void *context)
{
    const uint32_t before = mps2_transfers;
    int status;

    (void)context;
    SCENE.prepare(display->width, display->height);
    status = WORKERS > 1 ? draw_by_workers() : draw_by_one();
    if (status != 0)
        finish("FAIL: the display\n", 1);
    if (mps2_transfers - before < 15)
        finish("FAIL: it was not sent by interrupts\n", 1);
    if (WORKERS > 1 && (hand[0].strips == 0 || hand[WORKERS - 1].strips == 0))
        finish("FAIL: one task drew it alone\n", 1);
    if (other.frames == 0 || other.wrong)
        finish("FAIL: the other task\n", 1);
    finish("drawn\n", 0);
}

static int open_workers(void)
{
    int status;

    etch_freertos_monitor_open(&monitor);
    status = etch_workers_init(&workers, display, &monitor.monitor, 16);
    for (int i = 0; i < WORKERS && status == 0; i++) {
        const struct etch_frame_memory memory = {.pixels = {hand[i].pixels[0], hand[i].pixels[1]},
                                                 .depth = hand[i].depth,
                                                 .size = STRIP};

        status = etch_worker_init(&hand[i].worker, &workers, memory);
        (void)xTaskCreateStatic(i == 0 ? render : help, "worker", STACK, NULL, 1, hand[i].stack,
                                &hand[i].task);
    }
    return status;
}

int main(void)
{
    display = mps2_open();
    if (display == NULL || open_workers() != 0)
        return 1;
    (void)xTaskCreateStatic(draw_bar, "other", STACK, NULL, 2, other.stack, &other.task);
    vTaskStartScheduler();
    return 1;
}
