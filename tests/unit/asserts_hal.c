/* tests/unit: the bugs of callers that ETCH_ASSERT names in the HAL and the panel drivers, each
 * tripping it, in the build that watches core (harness/stores.h). */
#include "hal/dirty.h"
#include "hal/tiles.h"
#include "panel_parts.h"
#include "tests/harness/stores.h"

void suite_asserts_hal(void);

static uint16_t pixels[2][64], depth[64];
static struct etch_frame frame;
static struct etch_panel_port port;

static int flush(const struct etch_display *d, struct etch_rect area, const uint16_t *p,
                 uint16_t stride)
{
    (void)d, (void)area, (void)p, (void)stride;
    return 0;
}
static int wait(const struct etch_display *d)
{
    (void)d;
    return 0;
}
static const struct etch_display display = {.width = 8, .height = 8, .flush = flush, .wait = wait};
static const struct etch_frame_memory memory = {
    .pixels = {pixels[0], pixels[1]}, .depth = depth, .size = 64};

static void init_without_frame(void)
{
    (void)etch_frame_init(NULL, &display, memory);
}
static void init_without_display(void)
{
    (void)etch_frame_init(&frame, NULL, memory);
}
static void init_without_flush(void)
{
    struct etch_display d = display;

    d.flush = NULL;
    (void)etch_frame_init(&frame, &d, memory);
}
static void init_without_wait(void)
{
    struct etch_display d = display;

    d.wait = NULL;
    (void)etch_frame_init(&frame, &d, memory);
}
static void init_with_odd_memory(void)
{
    struct etch_frame_memory m = memory;

    m.pixels[1] = (uint16_t *)((uintptr_t)pixels[1] + 1);
    (void)etch_frame_init(&frame, &display, m);
}
static void init_with_odd_depth(void)
{
    struct etch_frame_memory m = memory;

    m.depth = (uint16_t *)((uintptr_t)depth + 1);
    (void)etch_frame_init(&frame, &display, m);
}
static void begin_without_areas(void)
{
    (void)etch_frame_init(&frame, &display, memory);
    (void)etch_frame_begin_areas(&frame, NULL, 1);
}
static void dirty_without_list(void)
{
    etch_dirty_add(NULL, (struct etch_rect){0, 0, 1, 1});
}
static void dirty_not_zeroed(void)
{
    struct etch_dirty dirty = {.count = 99};

    etch_dirty_add(&dirty, (struct etch_rect){0, 0, 1, 1});
}
static void tiles_without_hashes(void)
{
    struct etch_tiles tiles;

    (void)etch_tiles_init(&tiles, &display, (struct etch_tiles_setup){NULL, 64, 8, 8, 0});
}
static void transfer_without_start(void)
{
    static struct etch_transfer t;
    static struct etch_pieces pieces;

    (void)etch_transfer_start(&t, &pieces);
}
static void panel_without_bus(void)
{
    (void)etch_lcd_open(&port.lcd, &etch_ili9341, NULL, (struct etch_lcd_setup){0});
}
static void panel_without_table(void)
{
    (void)etch_lcd_open(&port.lcd, NULL, &port.bus.bus, (struct etch_lcd_setup){0});
}

static void bugs_of_callers_trip(void)
{
    CHECK(test_trips(init_without_frame));
    CHECK(test_trips(init_without_display));
    CHECK(test_trips(init_without_flush));
    CHECK(test_trips(init_without_wait));
    CHECK(test_trips(init_with_odd_memory));
    CHECK(test_trips(init_with_odd_depth));
    CHECK(test_trips(begin_without_areas));
    CHECK(test_trips(dirty_without_list));
    CHECK(test_trips(dirty_not_zeroed));
    CHECK(test_trips(tiles_without_hashes));
    CHECK(test_trips(transfer_without_start));
    CHECK(test_trips(panel_without_bus));
    CHECK(test_trips(panel_without_table));
}

static void sound_frame(void)
{
    CHECK_EQ(etch_frame_init(&frame, &display, memory), 0);
    CHECK(etch_frame_begin_areas(&frame, NULL, 0) == NULL);
    CHECK(etch_frame_begin(&frame) != NULL && etch_frame_next(&frame) == NULL);
    CHECK_EQ(etch_frame_end(&frame), 0);
}

static void sound_calls_do_not_trip(void)
{
    CHECK(!test_trips(sound_frame));
}

void suite_asserts_hal(void)
{
    RUN(sound_calls_do_not_trip);
    if (TEST_STORES)
        RUN(bugs_of_callers_trip);
    else
        test_print("assertions are empty here; `make stores` trips them");
}
