/* tests/unit: the frame loop on displays with memory of their own, and what set-up refuses. */
#include "frame_parts.h"

void suite_frame_direct(void);

/* Drawn into in place: one surface, told once, over the whole frame. */
static void a_direct_display_is_one_surface(void)
{
    struct etch_frame frame;
    const struct etch_frame_memory none = {.size = 0};
    int strips;

    open_panel(13, 21, true);
    CHECK_EQ(etch_frame_init(&frame, &display, none), 0);
    for (int n = 1; n <= 2; n++) {
        CHECK_EQ(draw_frame(&frame, n, &strips), 0);
        CHECK(strips == 1 && panel.flushes == 1);
        CHECK(panel.area.x0 == 0 && panel.area.y0 == 0 && panel.area.x1 == 13 &&
              panel.area.y1 == 21);
        check_glass(n, 1);
    }
}

/* A depth plane of fewer rows makes strips of them; the display still hears of one frame. */
static void a_small_depth_plane_makes_strips(void)
{
    struct etch_frame frame;
    const struct etch_frame_memory m = {.depth = buffer[2], .size = 5 * MAX_WIDTH};
    const struct etch_frame_memory small = {.depth = buffer[2], .size = MAX_WIDTH - 1};
    int strips;

    open_panel(13, 21, true);
    CHECK_EQ(etch_frame_init(&frame, &display, m), 0);
    CHECK_EQ(draw_frame(&frame, 1, &strips), 0);
    CHECK(strips == 5 && panel.flushes == 1);
    check_glass(1, 1);

    CHECK_EQ(etch_frame_init(&frame, &display, small), 0);
    CHECK(etch_frame_begin(&frame) == NULL);
    CHECK_EQ(etch_frame_end(&frame), ETCH_ENOMEM);
}

static uint16_t *no_memory(const struct etch_display *d, uint16_t *stride)
{
    (void)d, (void)stride;
    return NULL;
}

static uint16_t *narrow_memory(const struct etch_display *d, uint16_t *stride)
{
    *stride = (uint16_t)(d->width - 1);
    return panel.glass;
}

static void set_up_refuses(void)
{
    struct etch_frame frame;
    const struct etch_frame_memory none = {.size = 100};
    const struct etch_frame_memory same = {.pixels = {buffer[0], buffer[0]}, .size = 100};
    const struct etch_frame_memory little = {.pixels = {buffer[0], NULL}, .size = 9};

    open_panel(10, 10, false);
    CHECK_EQ(etch_frame_init(&frame, &display, none), ETCH_EINVAL);
    CHECK_EQ(etch_frame_init(&frame, &display, same), ETCH_EINVAL);
    CHECK_EQ(etch_frame_init(&frame, &display, little), ETCH_ENOMEM);
    display.width = 0;
    CHECK_EQ(etch_frame_init(&frame, &display, little), ETCH_EINVAL);
    display.width = 10;
    display.height = -1;
    CHECK_EQ(etch_frame_init(&frame, &display, little), ETCH_EINVAL);

    open_panel(10, 10, true);
    display.memory = no_memory;
    CHECK_EQ(etch_frame_init(&frame, &display, none), 0);
    CHECK(etch_frame_begin(&frame) == NULL && etch_frame_next(&frame) == NULL);
    CHECK_EQ(etch_frame_end(&frame), ETCH_EIO);
    display.memory = narrow_memory;
    CHECK(etch_frame_begin(&frame) == NULL);
    CHECK_EQ(etch_frame_end(&frame), ETCH_EINVAL);
    CHECK_EQ(panel.flushes, 0);
}

void suite_frame_direct(void)
{
    RUN(a_direct_display_is_one_surface);
    RUN(a_small_depth_plane_makes_strips);
    RUN(set_up_refuses);
}
