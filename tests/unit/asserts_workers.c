/* tests/unit: the bugs of callers that ETCH_ASSERT names in hal/workers.h, each tripping it, in the
 * build that watches core (harness/stores.h). */
#include "hal/workers.h"
#include "tests/harness/harness.h"
#include "tests/harness/stores.h"

void suite_asserts_workers(void);

static uint16_t pixels[2][64];
static struct etch_workers workers;
static struct etch_worker worker;

static int flush(const struct etch_display *d, struct etch_rect area, const uint16_t *p,
                 uint16_t stride)
{
    return (void)d, (void)area, (void)p, (void)stride, 0;
}

static int wait(const struct etch_display *d)
{
    return (void)d, 0;
}

static void nothing(const struct etch_monitor *m)
{
    (void)m;
}

static int go_on(const struct etch_monitor *m, uint16_t limit_ms)
{
    return (void)m, (void)limit_ms, 0;
}

static const struct etch_monitor monitor = {
    .enter = nothing, .leave = nothing, .wait = go_on, .signal = nothing};
static const struct etch_display display = {.width = 8, .height = 8, .flush = flush, .wait = wait};
static const struct etch_frame_memory memory = {.pixels = {pixels[0], pixels[1]}, .size = 64};

static void init_without_workers(void)
{
    (void)etch_workers_init(NULL, &display, &monitor, 8);
}
static void init_without_display(void)
{
    (void)etch_workers_init(&workers, NULL, &monitor, 8);
}
static void init_without_monitor(void)
{
    (void)etch_workers_init(&workers, &display, NULL, 8);
}
static void init_without_flush(void)
{
    struct etch_display d = display;

    d.flush = NULL;
    (void)etch_workers_init(&workers, &d, &monitor, 8);
}
static void init_without_wait(void)
{
    struct etch_display d = display;

    d.wait = NULL;
    (void)etch_workers_init(&workers, &d, &monitor, 8);
}
static void worker_without_worker(void)
{
    (void)etch_worker_init(NULL, &workers, memory);
}
static void worker_without_workers(void)
{
    (void)etch_worker_init(&worker, NULL, memory);
}
static void worker_with_odd_memory(void)
{
    struct etch_frame_memory m = memory;

    m.pixels[1] = (uint16_t *)((uintptr_t)pixels[1] + 1);
    (void)etch_worker_init(&worker, &workers, m);
}
static void begin_without_areas(void)
{
    etch_workers_begin_areas(&workers, NULL, 1);
}
static void begin_twice(void)
{
    etch_workers_begin(&workers);
    etch_workers_begin(&workers);
}

static void bugs_of_callers_trip(void)
{
    static void (*const bug[])(void) = {init_without_workers,   init_without_display,
                                        init_without_monitor,   init_without_flush,
                                        init_without_wait,      worker_without_worker,
                                        worker_without_workers, worker_with_odd_memory,
                                        begin_without_areas,    begin_twice};

    for (unsigned i = 0; i < sizeof bug / sizeof bug[0]; i++) {
        CHECK_EQ(etch_workers_init(&workers, &display, &monitor, 8), ETCH_OK);
        if (!CHECK(test_trips(bug[i])))
            test_note("bug", (int64_t)i);
    }
}

/* What looks alike and is allowed. */
static void no_bugs(void)
{
    CHECK_EQ(etch_workers_init(&workers, &display, &monitor, 8), ETCH_OK);
    CHECK_EQ(etch_worker_init(&worker, &workers, memory), ETCH_OK);
    etch_workers_begin_areas(&workers, NULL, 0);
    CHECK(etch_worker_begin(&worker));
    CHECK(etch_worker_next(&worker) == NULL);
    CHECK_EQ(etch_workers_end(&workers), ETCH_OK);
}

void suite_asserts_workers(void)
{
    RUN(no_bugs);
    if (TEST_STORES)
        RUN(bugs_of_callers_trip);
    else
        test_print("assertions are empty here; `make stores` trips them");
}
