/* tests/unit: the frame loop on displays that are sent strips. */
#include "frame_parts.h"

void suite_frame(void);

static const int16_t sizes[][2] = {{1, 1}, {5, 3}, {17, 9}, {40, 1}, {1, 40}, {33, 16}, {39, 40}};
static const int heights[] = {1, 7, 16, 40, 1000};

/* All sizes, strip heights and both numbers of buffers: each pixel arrives once, in order, and no
 * buffer is touched while it is sent; three frames one after the other. */
static void every_pixel_arrives_once(void)
{
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        for (size_t k = 0; k < sizeof heights / sizeof heights[0]; k++) {
            for (int buffers = 1; buffers <= 2; buffers++) {
                struct etch_frame frame;
                const int16_t height = sizes[i][1];
                const int rows = heights[k] < height ? heights[k] : height;
                int strips;

                open_panel(sizes[i][0], height, false);
                CHECK_EQ(etch_frame_init(&frame, &display, strips_of(heights[k], buffers)), 0);
                for (int n = 1; n <= 3; n++) {
                    CHECK_EQ(draw_frame(&frame, n, &strips), 0);
                    CHECK_EQ(strips, (height + rows - 1) / rows);
                    CHECK_EQ(panel.flushes, strips);
                    check_glass(n, 1);
                }
            }
        }
    }
}

/* With two buffers a transfer runs while the next strip is drawn; with one, none does. */
static void two_buffers_overlap(void)
{
    for (int buffers = 1; buffers <= 2; buffers++) {
        struct etch_frame frame;
        int overlapped = 0;

        open_panel(10, 40, false);
        CHECK_EQ(etch_frame_init(&frame, &display, strips_of(8, buffers)), 0);
        for (struct etch_surface *s = etch_frame_begin(&frame); s != NULL;
             s = etch_frame_next(&frame)) {
            overlapped += panel.pixels != NULL;
            draw(s, 1);
        }
        CHECK_EQ(etch_frame_end(&frame), 0);
        CHECK_EQ(overlapped, buffers == 2 ? 4 : 0); /* all of the five strips but the first */
        check_glass(1, 1);
    }
}

/* The k-th flush or wait fails: the frame ends there with the display's own number, nothing more
 * is sent, no transfer is left running, and the next frame is whole. */
static void errors_end_the_frame(void)
{
    for (int buffers = 1; buffers <= 2; buffers++) {
        for (int k = 1; k <= 10; k++) {
            struct etch_frame frame;
            const bool in_flush = k <= 5;
            const int call = in_flush ? k : k - 5;
            int strips;

            open_panel(9, 33, false); /* five strips of 7 rows, the last of 5 */
            CHECK_EQ(etch_frame_init(&frame, &display, strips_of(7, buffers)), 0);
            *(in_flush ? &panel.fail_flush : &panel.fail_wait) = call;
            CHECK_EQ(draw_frame(&frame, 1, &strips), in_flush ? -77 : -78);
            CHECK(panel.flushes <= call + (!in_flush && buffers == 2));
            CHECK(panel.pixels == NULL && etch_frame_next(&frame) == NULL);
            CHECK_EQ(etch_frame_end(&frame), in_flush ? -77 : -78);

            open_panel(9, 33, false);
            CHECK_EQ(draw_frame(&frame, 2, &strips), 0);
            CHECK_EQ(strips, 5);
            check_glass(2, 1);
        }
    }
}

/* Left early, the strip in hand is not sent, what was sent is complete, and a new frame begins
 * at the top, also without an end between them. */
static void a_frame_may_be_left(void)
{
    struct etch_frame frame;
    struct etch_surface *s;
    int strips;

    open_panel(8, 30, false);
    CHECK_EQ(etch_frame_init(&frame, &display, strips_of(10, 2)), 0);
    draw(etch_frame_begin(&frame), 1);
    draw(etch_frame_next(&frame), 1);
    CHECK_EQ(etch_frame_end(&frame), 0);
    CHECK(panel.pixels == NULL && panel.flushes == 1);
    CHECK(panel.writes[9 * MAX_WIDTH] == 1 && panel.writes[10 * MAX_WIDTH] == 0);

    draw(etch_frame_begin(&frame), 2);
    s = etch_frame_next(&frame);
    CHECK(s != NULL && panel.pixels != NULL);
    panel.writes[0] = 0;
    s = etch_frame_begin(&frame);
    CHECK(s != NULL && s->window.y0 == 0 && panel.pixels == NULL);
    open_panel(8, 30, false);
    CHECK_EQ(draw_frame(&frame, 3, &strips), 0);
    check_glass(3, 1);
}

/* A clip narrowed on one strip does not reach the next. */
static void each_strip_has_its_own_clip(void)
{
    struct etch_frame frame;
    int narrow = 0;

    open_panel(8, 30, false);
    CHECK_EQ(etch_frame_init(&frame, &display, strips_of(10, 2)), 0);
    for (struct etch_surface *s = etch_frame_begin(&frame); s != NULL;
         s = etch_frame_next(&frame)) {
        const struct etch_rect clip = {2, 2, 3, 25};

        narrow += s->clip.x0 != 0;
        etch_surface_clip(s, clip);
    }
    CHECK_EQ(narrow, 0);
}

void suite_frame(void)
{
    RUN(every_pixel_arrives_once);
    RUN(two_buffers_overlap);
    RUN(errors_end_the_frame);
    RUN(a_frame_may_be_left);
    RUN(each_strip_has_its_own_clip);
}
