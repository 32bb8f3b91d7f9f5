/* tests/threads: a frame drawn by several workers, each a thread. */
#include <string.h>

#include "hal/workers.h"
#include "tests/harness/harness.h"
#include "threads.h"

enum {
    WORKERS = 3
};

/* A worker, its memory and its own copy of the scene. */
struct hand {
    struct etch_worker worker;
    struct etch_scene scene;
    uint16_t pixels[2][STRIP], depth[STRIP];
    uint8_t stencil[STRIP];
    pthread_t thread;
    int strips;
};

static struct hand hand[WORKERS];
static struct wire wire;
static struct station station;
static struct etch_workers workers;
static struct etch_pthread_monitor monitor;
static int parts[2];   /* marks of shared work, one each */
static bool parts_bad; /* a strip was handed out before they were all set */

static void draw_strips(struct hand *h)
{
    uint16_t part;

    while (etch_worker_part(&h->worker, 2, &part))
        parts[part]++;
    for (struct etch_surface *s; (s = etch_worker_next(&h->worker)) != NULL; h->strips++) {
        if (parts[0] != 1 || parts[1] != 1)
            parts_bad = true;
        scene_draw(&h->scene, s);
    }
}

static void *help(void *context)
{
    struct hand *h = context;

    while (etch_worker_begin(&h->worker))
        draw_strips(h);
    return NULL;
}

/* Frames of one scene on a display: by this thread and count - 1 others. The last status. */
static int draw_by(int count, const struct etch_display *display, int buffers, const char *path,
                   int frames)
{
    int status = 0;

    CHECK(etch_pthread_monitor_open(&monitor));
    CHECK_EQ(etch_workers_init(&workers, display, &monitor.monitor, ROWS), 0);
    for (int i = 0; i < count; i++) {
        struct hand *h = &hand[i];
        const struct etch_frame_memory memory = {
            .pixels = {h->pixels[0], buffers == 2 ? h->pixels[1] : NULL},
            .depth = h->depth,
            .stencil = h->stencil,
            .size = STRIP};

        h->strips = 0;
        scene_open(&h->scene, path, display->format);
        CHECK_EQ(etch_worker_init(&h->worker, &workers, memory), 0);
        if (i > 0)
            CHECK_EQ(pthread_create(&h->thread, NULL, help, h), 0);
    }
    for (int i = 0; i < frames && status == 0; i++) {
        parts[0] = parts[1] = 0;
        etch_workers_begin(&workers);
        (void)etch_worker_begin(&hand[0].worker);
        draw_strips(&hand[0]);
        status = etch_workers_end(&workers);
    }
    etch_workers_close(&workers);
    for (int i = 0; i < count; i++) {
        if (i > 0)
            CHECK_EQ(pthread_join(hand[i].thread, NULL), 0);
        etch_scene_close(&hand[i].scene);
    }
    etch_pthread_monitor_close(&monitor);
    CHECK(!parts_bad);
    return status;
}

static int all_strips(int count)
{
    int strips = 0;

    for (int i = 0; i < count; i++)
        strips += hand[i].strips;
    return strips;
}

/* Frames on a panel whose transfers are a thread's, two buffers and one, in any order and from the
 * top. */
static void workers_on_a_panel(void)
{
    struct etch_display display;

    CHECK(wire_open(&wire, 20000));
    station_open(&station, &wire);
    display = station.lcd.display;
    for (int i = 0; i < 4; i++) {
        const char *path = scene_paths[i % scene_count];
        const int count = 2 + i % 2;

        display.in_order = i >= 2;
        station.status = draw_by(count, &display, 2 - i % 2, path, 2);
        CHECK_EQ(all_strips(count), 2 * HEIGHT / ROWS);
        station_check(&station, path);
    }
    station_close(&station);
    wire_close(&wire);
}

static uint16_t glass[WHOLE];

static uint16_t *glass_memory(const struct etch_display *d, uint16_t *stride)
{
    *stride = (uint16_t)d->width;
    return glass;
}

static int no_flush(const struct etch_display *d, struct etch_rect area, const uint16_t *pixels,
                    uint16_t stride)
{
    return (void)d, (void)area, (void)pixels, (void)stride, 0;
}

static int no_wait(const struct etch_display *d)
{
    return (void)d, 0;
}

/* Strips of one memory that the glass shows. */
static void workers_on_one_memory(void)
{
    static uint16_t alone[WHOLE];
    const struct etch_display display = {.width = WIDTH,
                                         .height = HEIGHT,
                                         .flush = no_flush,
                                         .wait = no_wait,
                                         .memory = glass_memory};

    for (int i = 0; i < scene_count; i++) {
        CHECK_EQ(draw_by(1, &display, 0, scene_paths[i], 1), 0);
        memcpy(alone, glass, sizeof glass);
        memset(glass, 0, sizeof glass);
        CHECK_EQ(draw_by(WORKERS, &display, 0, scene_paths[i], 1), 0);
        CHECK_EQ(memcmp(alone, glass, sizeof glass), 0);
    }
}

/* A transfer that never ends, at any strip: told once, and the next frame is whole. */
static void a_transfer_that_stalls(void)
{
    CHECK(wire_open(&wire, 600));
    station_open(&station, &wire);
    for (int at = 3; at <= 60; at += 27) {
        wire.stalls = at;
        CHECK_EQ(draw_by(WORKERS, &station.lcd.display, 2, scene_paths[0], 3), ETCH_EIO);
        CHECK_EQ(wire.stalls, 0);
        station.status = draw_by(WORKERS, &station.lcd.display, 2, scene_paths[0], 1);
        station_check(&station, scene_paths[0]);
    }
    station_close(&station);
    wire_close(&wire);
}

void suite_workers(void)
{
    RUN(workers_on_a_panel);
    RUN(workers_on_one_memory);
    RUN(a_transfer_that_stalls);
}
