/* tests/unit: the bugs of callers that ETCH_ASSERT names, each tripping it, in the build that
 * watches core (harness/stores.h). In every other build assertions are empty. */
#include "core/base/fixed.h"
#include "core/draw/shapes.h"
#include "tests/harness/harness.h"
#include "tests/harness/stores.h"

void suite_asserts(void);

static uint16_t memory[16], plane[16];
static struct etch_surface surface;
static const struct etch_rect window = {0, 0, 4, 4};

/* The same memory, one byte further on. */
static uint16_t *odd(uint16_t *p)
{
    return (uint16_t *)((uintptr_t)p + 1);
}

static void sound_surface(void)
{
    CHECK_EQ(etch_surface_init(&surface, memory, window, 4), ETCH_OK);
    surface.depth = plane;
}

static void init_without_surface(void)
{
    (void)etch_surface_init(NULL, memory, window, 4);
}
static void init_with_odd_pixels(void)
{
    (void)etch_surface_init(&surface, odd(memory), window, 4);
}
static void clip_without_surface(void)
{
    etch_surface_clip(NULL, window);
}
static void clear_without_surface(void)
{
    etch_surface_clear(NULL, 0);
}
static void clear_odd_pixels(void)
{
    sound_surface();
    surface.pixels = odd(memory);
    etch_surface_clear(&surface, 0);
}
static void clear_depth_without_surface(void)
{
    etch_depth_clear(NULL, 0);
}
static void clear_depth_without_plane(void)
{
    sound_surface();
    surface.depth = NULL;
    etch_depth_clear(&surface, 0);
}
static void clear_odd_depth(void)
{
    sound_surface();
    surface.depth = odd(plane);
    etch_depth_clear(&surface, 0);
}
static void divide_by_zero(void)
{
    (void)etch_divide_u64(1, 0);
}
static void divide_by_too_much(void)
{
    (void)etch_divide_u64(1, (UINT64_C(1) << 63) + 1);
}

static void bugs_of_callers_trip(void)
{
    CHECK(test_trips(init_without_surface));
    CHECK(test_trips(init_with_odd_pixels));
    CHECK(test_trips(clip_without_surface));
    CHECK(test_trips(clear_without_surface));
    CHECK(test_trips(clear_odd_pixels));
    CHECK(test_trips(clear_depth_without_surface));
    CHECK(test_trips(clear_depth_without_plane));
    CHECK(test_trips(clear_odd_depth));
    CHECK(test_trips(divide_by_zero));
    CHECK(test_trips(divide_by_too_much));
}

static void clear_all(void)
{
    sound_surface();
    etch_surface_clip(&surface, window);
    etch_surface_clear(&surface, 1);
    etch_depth_clear(&surface, 2);
    (void)etch_divide_u64(1, UINT64_C(1) << 63);
}

static void sound_calls_do_not_trip(void)
{
    CHECK(!test_trips(clear_all));
    CHECK(memory[15] == 1 && plane[15] == 2);
}

void suite_asserts(void)
{
    RUN(sound_calls_do_not_trip);
    if (TEST_STORES)
        RUN(bugs_of_callers_trip);
    else
        test_print("assertions are empty here; `make stores` trips them");
}
