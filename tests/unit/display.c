/* tests/unit: display colours, and the framebuffer port under the frame loop, two of them side by
 * side. */
#include "core/draw/shapes.h"
#include "hal/frame.h"
#include "ports/framebuffer/framebuffer.h"
#include "tests/harness/harness.h"

void suite_display(void);

static void color_follows_the_format(void)
{
    const struct etch_display plain = {.format = ETCH_FORMAT_RGB565};
    const struct etch_display swapped = {.format = ETCH_FORMAT_RGB565_SWAPPED};

    CHECK_EQ(etch_display_color(&plain, 255, 0, 0), 0xF800);
    CHECK_EQ(etch_display_color(&plain, 0, 255, 0), 0x07E0);
    CHECK_EQ(etch_display_color(&swapped, 255, 0, 0), 0x00F8);
    CHECK_EQ(etch_display_color(&swapped, 0, 255, 0), 0xE007);
}

enum {
    WIDTH = 6,
    HEIGHT = 4,
    STRIDE = 9,
    GUARD = 0x5A5A
};

static uint16_t pixels[2][STRIDE * HEIGHT];
static struct etch_framebuffer framebuffers[2] = {{pixels[0], STRIDE}, {pixels[1], STRIDE}};

#define FRAMEBUFFER(i, order)                                                                      \
    {                                                                                              \
        .context = &framebuffers[i], .width = WIDTH, .height = HEIGHT, .format = order,            \
        .flush = etch_framebuffer_flush, .wait = etch_framebuffer_wait,                            \
        .memory = etch_framebuffer_memory                                                          \
    }

static const struct etch_display displays[2] = {FRAMEBUFFER(0, ETCH_FORMAT_RGB565),
                                                FRAMEBUFFER(1, ETCH_FORMAT_RGB565_SWAPPED)};

/* Two frames at once, interleaved: each display gets its own picture in its own byte order, and
 * the memory between the rows is left alone. */
static void two_displays_at_once(void)
{
    const struct etch_frame_memory none = {.size = 0};
    struct etch_frame frame[2];
    struct etch_surface *s[2];

    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < STRIDE * HEIGHT; k++)
            pixels[i][k] = GUARD;
        CHECK_EQ(etch_frame_init(&frame[i], &displays[i], none), 0);
        s[i] = etch_frame_begin(&frame[i]);
    }
    for (int i = 0; i < 2; i++) {
        etch_surface_clear(s[i], etch_display_color(&displays[i], 0, 0, 255));
        etch_rect_fill(s[i], 1, 1, 100, 1, etch_display_color(&displays[i], 255, 0, 0));
    }
    for (int i = 0; i < 2; i++) {
        CHECK(etch_frame_next(&frame[i]) == NULL);
        CHECK_EQ(etch_frame_end(&frame[i]), 0);
        for (int k = 0; k < STRIDE * HEIGHT; k++) {
            const int x = k % STRIDE, y = k / STRIDE;
            const uint16_t red = i == 0 ? 0xF800 : 0x00F8;
            const uint16_t blue = i == 0 ? 0x001F : 0x1F00;

            CHECK_EQ(pixels[i][k], x >= WIDTH ? GUARD : x >= 1 && y == 1 ? red : blue);
        }
    }
}

void suite_display(void)
{
    RUN(color_follows_the_format);
    RUN(two_displays_at_once);
}
