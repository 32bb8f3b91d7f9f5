/* tests/unit: hal/workers.h with workers that take their steps in a random order, one at a time, in
 * this thread: the monitor's wait lets the others go on. Real threads are in tests/threads. */
#include "hal/workers.h"

#include "frame_parts.h"

void suite_workers(void);

enum {
    WORKERS = 4,
    PARTS = 5
};

static struct etch_workers workers;
static struct {
    struct etch_worker worker;
    struct etch_surface *strip; /* in hand */
    uint16_t part[2];           /* parts it got, of each of two phases */
    int at;                     /* 0, 1: phase; 2: strips; 3: done with the frame */
    bool called;                /* is in a call that waits */
} w[WORKERS];
static uint16_t planes[WORKERS][3][MAX_SIZE];
static int count;         /* of workers */
static int inside, waits; /* of the monitor */
static int phase_done[2]; /* parts that are done */
static int number;        /* of the frame */
static int16_t lowest;    /* last row that was flushed */
static int disorder;      /* flushes not from top to bottom */
static int syncs;         /* calls of sync in this frame, */
static int fail_sync;     /* and what they return */
static uint32_t seed;

/* ---- a monitor whose wait runs the others ---------------------------------------------------- */

static void enter(const struct etch_monitor *m)
{
    (void)m;
    CHECK_EQ(inside, 0);
    inside++;
}

static void leave(const struct etch_monitor *m)
{
    (void)m;
    CHECK_EQ(inside, 1);
    inside--;
}

static void step(int i);

/* The free worker that is the furthest behind, so that one that waits for its turn gets it. */
static int furthest_behind(void)
{
    int found = -1;

    for (int i = 0; i < count; i++)
        if (!w[i].called && w[i].at < 3 &&
            (found < 0 || w[i].at < w[found].at ||
             (w[i].at == w[found].at && w[i].worker.strip < w[found].worker.strip)))
            found = i;
    return found;
}

static int let_go_on(const struct etch_monitor *m, uint16_t limit_ms)
{
    const int i = furthest_behind();

    CHECK_EQ(limit_ms, 0);
    CHECK(i >= 0); /* else all wait for each other */
    waits++;
    leave(m);
    if (i >= 0)
        step(i);
    enter(m);
    return i >= 0 ? 0 : ETCH_EIO;
}

static void signal(const struct etch_monitor *m)
{
    (void)m;
    CHECK_EQ(inside, 1);
}

static const struct etch_monitor monitor = {
    .enter = enter, .leave = leave, .wait = let_go_on, .signal = signal};

/* ---- workers --------------------------------------------------------------------------------- */

static int flush_in_order(const struct etch_display *d, struct etch_rect area,
                          const uint16_t *pixels, uint16_t stride)
{
    CHECK_EQ(inside, 0); /* displays are called outside */
    CHECK(d->align_y < 2 ||
          (area.y0 % d->align_y == 0 && (area.y1 % d->align_y == 0 || area.y1 == d->height)));
    CHECK(d->sync == NULL || syncs == 1);
    disorder += area.y0 < lowest;
    lowest = area.y0;
    return flush(d, area, pixels, stride);
}

static int count_sync(const struct etch_display *d)
{
    (void)d;
    CHECK_EQ(inside, 0);
    syncs++;
    return fail_sync;
}

/* One call of worker i, and what it draws before. */
static void step(int i)
{
    uint16_t part;

    w[i].called = true;
    if (w[i].at < 2) {
        const int phase = w[i].at;

        if (etch_worker_part(&w[i].worker, PARTS, &part)) {
            CHECK(part < PARTS && (phase == 0 || phase_done[0] == PARTS));
            phase_done[phase]++;
        } else {
            CHECK_EQ(phase_done[phase], PARTS);
            w[i].at++;
        }
    } else {
        if (w[i].strip != NULL)
            draw(w[i].strip, number);
        w[i].strip = etch_worker_next(&w[i].worker);
        CHECK(w[i].strip == NULL || w[i].strip->depth == w[i].worker.memory.depth);
        if (w[i].strip == NULL)
            w[i].at = 3;
    }
    w[i].called = false;
}

/* Draws a frame: random workers take a step until all are done, or only some come at all. */
static int draw_by_all(const struct etch_rect *areas, uint16_t areas_count)
{
    const int come = test_range(&seed, 1, count);

    number++;
    phase_done[0] = phase_done[1] = 0;
    lowest = 0;
    disorder = syncs = 0;
    if (areas != NULL)
        etch_workers_begin_areas(&workers, areas, areas_count);
    else
        etch_workers_begin(&workers);
    for (int i = 0; i < count; i++) {
        w[i].at = i < come ? 0 : 3;
        w[i].strip = NULL;
        if (i < come)
            CHECK(etch_worker_begin(&w[i].worker));
    }
    while (furthest_behind() >= 0) {
        const int i = test_range(&seed, 0, count - 1);

        if (w[i].at < 3)
            step(i);
        if (w[i].at == 3 && test_range(&seed, 0, 3) == 0)
            break; /* the owner ends it and waits for the others */
    }
    return etch_workers_end(&workers);
}

/* Workers with memory for 2 .. 5 rows, one or two buffers, some with a depth plane. */
static void open_workers(bool direct, bool in_order, int rows)
{
    open_panel((int16_t)test_range(&seed, 1, MAX_WIDTH), (int16_t)test_range(&seed, 1, MAX_HEIGHT),
               direct);
    display.flush = flush_in_order;
    if (in_order && test_range(&seed, 0, 1) != 0)
        display.sync = count_sync; /* wants the same */
    else
        display.in_order = in_order;
    display.align_y = (uint8_t)test_range(&seed, 0, rows < 2 ? rows : 2);
    CHECK_EQ(etch_workers_init(&workers, &display, &monitor, (int16_t)rows), ETCH_OK);
    count = test_range(&seed, 1, WORKERS);
    for (int i = 0; i < count; i++) {
        struct etch_frame_memory memory = {.pixels = {planes[i][0], planes[i][1]},
                                           .size = (uint32_t)test_range(&seed, 2, 5) * MAX_WIDTH};

        if (test_range(&seed, 0, 1) != 0)
            memory.pixels[1] = NULL;
        if (direct || test_range(&seed, 0, 1) != 0)
            memory.depth = planes[i][2];
        CHECK_EQ(etch_worker_init(&w[i].worker, &workers, memory), ETCH_OK);
    }
}

/* ---- cases ----------------------------------------------------------------------------------- */

/* Whatever the order, each pixel is drawn, sent once, and from a buffer that nobody touches. */
static void any_order_of_workers(void)
{
    seed = 1;
    for (int32_t i = 0; i < TEST_COUNT(600) && !test_failed(); i++) {
        const bool direct = i % 4 == 3, in_order = i % 2 != 0;

        open_workers(direct, in_order, test_range(&seed, 1, 9));
        for (int k = 0; k < 3 && !test_failed(); k++) {
            CHECK_EQ(draw_by_all(NULL, 0), 0);
            check_glass(number, 1);
            CHECK(!in_order || disorder == 0);
            CHECK_EQ(syncs, display.sync != NULL);
        }
    }
    CHECK(waits > 0);
}

/* Areas: what is outside of them stays as it was. */
static void areas_by_several(void)
{
    seed = 2;
    for (int32_t i = 0; i < TEST_COUNT(300) && !test_failed(); i++) {
        struct etch_rect area[2];
        int differ = 0, before;

        open_workers(false, i % 2 != 0, test_range(&seed, 1, 9));
        display.align_y = 0; /* else they grow */
        CHECK_EQ(draw_by_all(NULL, 0), 0);
        before = number;
        for (int k = 0; k < 2; k++) {
            area[k].x0 = (int16_t)test_range(&seed, -5, MAX_WIDTH);
            area[k].y0 = (int16_t)(test_range(&seed, 0, 15) + 20 * k);
            area[k].x1 = (int16_t)(area[k].x0 + test_range(&seed, -1, 20));
            area[k].y1 = (int16_t)(area[k].y0 + test_range(&seed, -1, 5));
        }
        CHECK_EQ(draw_by_all(area, 2), 0);
        for (int y = 0; y < display.height; y++)
            for (int x = 0; x < display.width; x++) {
                const bool in = (x >= area[0].x0 && x < area[0].x1 && y >= area[0].y0 &&
                                 y < area[0].y1) ||
                                (x >= area[1].x0 && x < area[1].x1 && y >= area[1].y0 &&
                                 y < area[1].y1);

                differ += panel.glass[y * MAX_WIDTH + x] != pattern(x, y, in ? number : before);
            }
        CHECK_EQ(differ, 0);
        CHECK_EQ(panel.early + panel.protocol, 0);
    }
}

/* The first error is told by etch_workers_end and by nothing else, nothing is sent after it, and
 * the next frame is whole. */
static void an_error_is_told_once(void)
{
    seed = 3;
    for (int32_t i = 0; i < TEST_COUNT(600) && !test_failed(); i++) {
        const bool at_flush = i % 2 != 0;
        int status, flushes, most;

        open_workers(false, i % 3 == 0, 2);
        most = (display.height + 1) / 2;
        if (at_flush)
            panel.fail_flush = test_range(&seed, 1, most);
        else
            panel.fail_wait = test_range(&seed, 1, most);
        status = draw_by_all(NULL, 0);
        flushes = panel.flushes;
        CHECK_EQ(status, at_flush ? -77 : -78);
        CHECK(!at_flush || flushes == panel.fail_flush);
        CHECK(at_flush || flushes <= panel.fail_wait + 1);
        CHECK(panel.pixels == NULL);
        panel.fail_flush = panel.fail_wait = 0;
        for (int k = 0; k < MAX_SIZE; k++)
            panel.writes[k] = 0;
        CHECK_EQ(draw_by_all(NULL, 0), 0);
        check_glass(number, 1);
    }
}

static void a_sync_that_fails(void)
{
    seed = 6;
    for (int i = 0; i < 40; i++) {
        open_workers(i % 2 != 0, true, 2);
        display.sync = count_sync;
        fail_sync = -79;
        CHECK_EQ(draw_by_all(NULL, 0), -79);
        CHECK_EQ(panel.flushes, 0);
        fail_sync = 0;
        CHECK_EQ(draw_by_all(NULL, 0), 0);
        check_glass(number, 1);
    }
}

static uint16_t *no_memory(const struct etch_display *d, uint16_t *stride)
{
    (void)d, (void)stride;
    return NULL;
}

static void memory_that_fails(void)
{
    seed = 4;
    open_workers(true, false, 4);
    display.memory = no_memory;
    CHECK_EQ(draw_by_all(NULL, 0), ETCH_EIO);
    CHECK_EQ(panel.flushes, 0);
    display.memory = memory;
    for (int i = 0; i < count; i++)
        w[i].worker.memory.size = (uint32_t)MAX_WIDTH - 1; /* a depth plane of less than a row */
    CHECK_EQ(draw_by_all(NULL, 0), ETCH_ENOMEM);
    CHECK_EQ(panel.flushes, 0);
}

static void arguments(void)
{
    struct etch_frame_memory memory = {.pixels = {planes[0][0], NULL}, .size = 10};

    open_panel(10, 20, false);
    CHECK_EQ(etch_workers_init(&workers, &display, &monitor, 0), ETCH_EINVAL);
    CHECK_EQ(etch_workers_init(&workers, &display, &monitor, 1), ETCH_OK);
    CHECK_EQ(etch_worker_init(&w[0].worker, &workers, memory), ETCH_OK);
    memory.size = 9;
    CHECK_EQ(etch_worker_init(&w[0].worker, &workers, memory), ETCH_ENOMEM);
    memory.pixels[1] = memory.pixels[0];
    CHECK_EQ(etch_worker_init(&w[0].worker, &workers, memory), ETCH_EINVAL);
    memory.pixels[0] = NULL;
    CHECK_EQ(etch_worker_init(&w[0].worker, &workers, memory), ETCH_EINVAL);
    display.align_y = 8;
    CHECK_EQ(etch_workers_init(&workers, &display, &monitor, 7), ETCH_EINVAL);
    CHECK_EQ(etch_workers_init(&workers, &display, &monitor, 15), ETCH_OK);
    CHECK_EQ(workers.rows, 8);
    display.height = 0;
    CHECK_EQ(etch_workers_init(&workers, &display, &monitor, 7), ETCH_EINVAL);
}

/* A worker that is late for a frame gets nothing of it, joins the next, and is sent home. */
static void late_workers(void)
{
    uint16_t part;

    seed = 5;
    do
        open_workers(false, false, 2);
    while (count < 2);
    etch_workers_begin(&workers);
    CHECK(etch_worker_begin(&w[1].worker)); /* joins, and falls asleep */
    w[1].at = 3;
    CHECK(etch_worker_begin(&w[0].worker));
    for (w[0].at = 0; w[0].at < 2;) { /* alone through both phases */
        phase_done[w[0].at] = 0;
        while (etch_worker_part(&w[0].worker, PARTS, &part))
            phase_done[w[0].at]++;
        CHECK_EQ(phase_done[w[0].at++], PARTS);
    }
    number++;
    for (struct etch_surface *s; (s = etch_worker_next(&w[0].worker)) != NULL;)
        draw(s, number);
    CHECK_EQ(etch_workers_end(&workers), 0);
    check_glass(number, 1);
    CHECK(!etch_worker_part(&w[1].worker, PARTS, &part));
    CHECK(etch_worker_next(&w[1].worker) == NULL);
    etch_workers_begin(&workers);
    CHECK(!etch_worker_part(&w[1].worker, PARTS, &part)); /* it is still of the frame before */
    CHECK(etch_worker_begin(&w[1].worker));
    CHECK(etch_worker_part(&w[1].worker, 1, &part));
    CHECK_EQ(part, 0);
    CHECK(!etch_worker_part(&w[1].worker, 1, &part));
    number++;
    for (struct etch_surface *s; (s = etch_worker_next(&w[1].worker)) != NULL;)
        draw(s, number);
    CHECK_EQ(etch_workers_end(&workers), 0);
    check_glass(number, 1);
    etch_workers_close(&workers);
    CHECK(!etch_worker_begin(&w[0].worker));
}

void suite_workers(void)
{
    RUN(any_order_of_workers);
    RUN(areas_by_several);
    RUN(an_error_is_told_once);
    RUN(a_sync_that_fails);
    RUN(memory_that_fails);
    RUN(arguments);
    RUN(late_workers);
}
