/* tests/workers: workers COUNT FRAMES: draws frames of a torus of 50,000 triangles by COUNT
 * threads, each of which counts as a worker; compares each with the frame of one thread on one
 * surface, and prints the microseconds that the frames took. The rows of a strip are those of one
 * alone divided by COUNT, so that however many there are they share the same memory. workers.sh
 * counts instructions in draw_share. */
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "ports/pthread/pthread_monitor.h"
#include "torus.h"

enum {
    WIDTH = 320,
    HEIGHT = 240,
    ROWS = 12, /* of a strip of one alone */
    STRIP = WIDTH * ROWS,
    MOST = 8
};

static struct torus torus;
static struct etch_workers workers;
static struct {
    struct etch_worker worker;
    uint16_t pixels[2][STRIP], depth[STRIP];
    pthread_t thread;
} hand[MOST];
static uint16_t glass[WIDTH * HEIGHT], expected[WIDTH * HEIGHT], depth[WIDTH * HEIGHT];

/* ---- a display that has what it gets at once ------------------------------------------------- */

static int flush(const struct etch_display *d, struct etch_rect area, const uint16_t *pixels,
                 uint16_t stride)
{
    (void)d;
    for (int16_t y = area.y0; y < area.y1; y++, pixels += stride)
        memcpy(glass + y * WIDTH + area.x0, pixels, (size_t)(area.x1 - area.x0) * sizeof *pixels);
    return 0;
}

static int wait(const struct etch_display *d)
{
    return (void)d, 0;
}

static const struct etch_display display = {
    .width = WIDTH, .height = HEIGHT, .flush = flush, .wait = wait};

/* ---- workers --------------------------------------------------------------------------------- */

void draw_share(struct etch_worker *worker);

__attribute__((noinline)) void draw_share(struct etch_worker *worker)
{
    torus_draw_share(&torus, worker);
}

static void *help(void *context)
{
    struct etch_worker *worker = context;

    while (etch_worker_begin(worker))
        draw_share(worker);
    return NULL;
}

static uint64_t now_us(void)
{
    struct timespec t;

    (void)clock_gettime(CLOCK_MONOTONIC, &t);
    return (uint64_t)t.tv_sec * 1000000 + (uint64_t)t.tv_nsec / 1000;
}

/* The time of a frame; 0 if it is not right. */
static uint64_t draw_frame(uint16_t turn)
{
    const struct etch_rect window = {0, 0, WIDTH, HEIGHT};
    struct etch_surface whole;
    uint64_t begin;
    int status;

    torus_turn(&torus, turn, WIDTH, HEIGHT);
    (void)etch_surface_init(&whole, expected, window, WIDTH);
    whole.depth = depth;
    torus_draw_alone(&torus, &whole);
    begin = now_us();
    etch_workers_begin(&workers);
    (void)etch_worker_begin(&hand[0].worker);
    draw_share(&hand[0].worker);
    status = etch_workers_end(&workers);
    begin = now_us() - begin + 1;
    return status == 0 && memcmp(glass, expected, sizeof glass) == 0 ? begin : 0;
}

static bool open_workers(const struct etch_monitor *monitor, int count)
{
    if (etch_workers_init(&workers, &display, monitor, (int16_t)(ROWS / count)) != 0)
        return false;
    for (int i = 0; i < count; i++) {
        const struct etch_frame_memory memory = {.pixels = {hand[i].pixels[0], hand[i].pixels[1]},
                                                 .depth = hand[i].depth,
                                                 .size = STRIP};

        if (etch_worker_init(&hand[i].worker, &workers, memory) != 0 ||
            (i > 0 && pthread_create(&hand[i].thread, NULL, help, &hand[i].worker) != 0))
            return false;
    }
    return true;
}

int main(int argc, char **argv)
{
    const int count = argc == 3 ? atoi(argv[1]) : 0, frames = argc == 3 ? atoi(argv[2]) : 0;
    struct etch_pthread_monitor monitor;
    uint64_t total = 0;

    if (count < 1 || count > MOST || frames < 1) {
        fputs("usage: workers COUNT FRAMES\n", stderr);
        return 2;
    }
    torus_make(&torus);
    if (!etch_pthread_monitor_open(&monitor) || !open_workers(&monitor.monitor, count))
        return 1;
    for (int i = 0; i < frames; i++) {
        const uint64_t us = draw_frame((uint16_t)(i * 5000));

        if (us == 0) {
            fprintf(stderr, "frame %d differs\n", i);
            return 1;
        }
        total += us;
    }
    etch_workers_close(&workers);
    for (int i = 1; i < count; i++)
        (void)pthread_join(hand[i].thread, NULL);
    etch_pthread_monitor_close(&monitor);
    printf("%lu\n", (unsigned long)total);
    return 0;
}
