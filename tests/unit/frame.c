/* tests/unit: the frame loop, against a display whose transfers take place when they are waited
 * for and which notices every buffer that was touched before. */
#include "hal/frame.h"
#include "tests/harness/harness.h"

void suite_frame(void);

enum {
    MAX_WIDTH = 40,
    MAX_HEIGHT = 40,
    MAX_SIZE = MAX_WIDTH * MAX_HEIGHT
};

/* A panel with its own memory. */
struct panel {
    uint16_t glass[MAX_SIZE], sent[MAX_SIZE]; /* shown; the buffer as flush got it */
    uint8_t writes[MAX_SIZE];                 /* of each pixel, in this frame */
    const uint16_t *pixels;                   /* of the running transfer, or NULL */
    struct etch_rect area;
    uint16_t stride;
    int flushes, waits;        /* calls in this frame */
    int fail_flush, fail_wait; /* number of the call that fails, from 1; 0: none */
    int early;                 /* buffers touched before their transfer had ended */
    int protocol;              /* calls that hal/display.h forbids */
};

static struct panel panel;
static uint16_t buffer[3][MAX_SIZE];
static struct etch_display display;

static int flush(const struct etch_display *d, struct etch_rect area, const uint16_t *pixels,
                 uint16_t stride)
{
    struct panel *p = d->context;
    const bool inside = area.x0 >= 0 && area.y0 >= 0 && area.x1 <= d->width && area.y1 <= d->height;

    p->protocol += p->pixels != NULL || etch_rect_is_empty(area) || !inside ||
                   stride < area.x1 - area.x0;
    if (++p->flushes == p->fail_flush)
        return -77;
    p->pixels = pixels;
    p->area = area;
    p->stride = stride;
    for (int16_t y = area.y0; y < area.y1; y++)
        for (int16_t x = area.x0; x < area.x1; x++)
            p->sent[y * MAX_WIDTH + x] = pixels[(y - area.y0) * stride + x - area.x0];
    return 0;
}

/* The transfer takes place now, at the latest moment allowed. */
static int wait(const struct etch_display *d)
{
    struct panel *p = d->context;
    const struct etch_rect area = p->area;
    const uint16_t *pixels = p->pixels;
    bool touched = false;

    p->pixels = NULL;
    if (pixels == NULL)
        return 0;
    if (++p->waits == p->fail_wait)
        return -78;
    for (int16_t y = area.y0; y < area.y1; y++) {
        for (int16_t x = area.x0; x < area.x1; x++) {
            const int at = y * MAX_WIDTH + x;

            p->glass[at] = pixels[(y - area.y0) * p->stride + x - area.x0];
            p->writes[at]++;
            touched |= p->glass[at] != p->sent[at];
        }
    }
    p->early += touched;
    return 0;
}

static uint16_t *memory(const struct etch_display *d, uint16_t *stride)
{
    struct panel *p = d->context;

    *stride = MAX_WIDTH;
    return p->glass;
}

static void open_panel(int16_t width, int16_t height, bool direct)
{
    static const struct panel nothing;
    const struct etch_display d = {.context = &panel,
                                   .width = width,
                                   .height = height,
                                   .flush = flush,
                                   .wait = wait,
                                   .memory = direct ? memory : NULL};

    panel = nothing;
    display = d;
}

static uint16_t pattern(int x, int y, int frame_number)
{
    return (uint16_t)(x * 251 + y * 17 + frame_number * 4099 + 1);
}

/* Draws the pattern on a strip, after checking that no running transfer reads from it. */
static void draw(const struct etch_surface *s, int frame_number)
{
    const size_t size = (size_t)(s->window.y1 - s->window.y0) * s->stride;

    CHECK(panel.pixels == NULL || panel.pixels + size <= s->pixels ||
          panel.pixels >= s->pixels + size);
    for (int16_t y = s->window.y0; y < s->window.y1; y++)
        for (int16_t x = s->window.x0; x < s->window.x1; x++)
            s->pixels[etch_surface_index(s, x, y)] = pattern(x, y, frame_number);
}

static int draw_frame(struct etch_frame *frame, int frame_number, int *strips)
{
    int16_t row = 0;

    *strips = 0;
    for (struct etch_surface *s = etch_frame_begin(frame); s != NULL; s = etch_frame_next(frame)) {
        CHECK(s->window.x0 == 0 && s->window.x1 == display.width && s->window.y0 == row);
        CHECK(s->clip.x1 == s->window.x1 && s->clip.y0 == row && s->clip.y1 == s->window.y1);
        row = s->window.y1;
        draw(s, frame_number);
        ++*strips;
    }
    return etch_frame_end(frame);
}

static void check_glass(int frame_number, int writes)
{
    for (int y = 0; y < display.height && !test_failed(); y++) {
        for (int x = 0; x < display.width; x++) {
            const int at = y * MAX_WIDTH + x;

            CHECK_EQ(panel.glass[at], pattern(x, y, frame_number));
            CHECK_EQ(panel.writes[at], writes);
            panel.writes[at] = 0;
        }
    }
    CHECK_EQ(panel.early, 0);
    CHECK_EQ(panel.protocol, 0);
    panel.flushes = panel.waits = 0;
}

static struct etch_frame_memory strips_of(int rows, int buffers)
{
    const struct etch_frame_memory m = {
        .pixels = {buffer[0], buffers == 2 ? buffer[1] : NULL},
        .size = (uint32_t)(rows * display.width + (display.width - 1)), /* no whole row more */
    };
    return m;
}

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

void suite_frame(void)
{
    RUN(every_pixel_arrives_once);
    RUN(two_buffers_overlap);
    RUN(errors_end_the_frame);
    RUN(a_frame_may_be_left);
    RUN(each_strip_has_its_own_clip);
    RUN(a_direct_display_is_one_surface);
    RUN(a_small_depth_plane_makes_strips);
    RUN(set_up_refuses);
}
